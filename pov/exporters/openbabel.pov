// POV-Ray V3.1 code in the manner of Open Babel
#include "openbabel.inc"

#if (version < 3.1)
	#error "POV-Ray 3.1"
#end
#declare BAS = true;
#declare SPF = false;

//Coordinates of atoms 1 - 4
#declare mol_0_pos_0 = <0.00000,0.00000,0.00000>;
#declare mol_0_pos_1 = <1.22000,0.30000,0.10000>;
#declare mol_0_pos_2 = <-0.60000,0.90000,-0.20000>;
#declare mol_0_pos_3 = <-0.50000,-0.95000,0.10000>;

//Povray-description of atoms 1 - 4
#declare mol_0_atom0 = 
object {
	  Atom_Carbon
	  translate mol_0_pos_0
	 }
#declare mol_0_atom1 = 
object {
	  Atom_Oxygen
	  translate mol_0_pos_1
	 }
#declare mol_0_atom2 = 
object {
	  Atom_Hydrogen
	  translate mol_0_pos_2
	 }
#declare mol_0_atom3 = 
object {
	  Atom_Hydrogen
	  translate mol_0_pos_3
	 }

#if (BAS)
#declare mol_0_bond0 = 
object {
	  bond_2
	  scale <1.26032,1.0000,1.0000>
	  rotate <0.0000,0.0000,13.7692>
	  rotate <0.0000,-4.6859,0.0000>
	  translate mol_0_pos_0
	 }
#declare mol_0_bond1 = 
object {
	  bond_1
	  scale <1.10000,1.0000,1.0000>
	  rotate <0.0000,0.0000,54.9032>
	  rotate <0.0000,-161.5651,0.0000>
	  translate mol_0_pos_0
	 }
#end //(BAS)

#declare mol_0 = 
union {
#if (BAS | SPF)
	  object {mol_0_atom0}
	  object {mol_0_atom1}
	  object {mol_0_atom2}
	  object {mol_0_atom3}
#end
#if (BAS)
	  object {mol_0_bond0}
	  object {mol_0_bond1}
#end
	 }
#declare mol_0_center = <0.03000,0.06250,0.00000>;

background { color rgb <0.8, 0.85, 0.9> }
camera { location mol_0_center+<0, 0, -4> look_at mol_0_center }
light_source { <-10, 20, -30> color rgb <1, 1, 1> }
object {
	  mol_0
	  translate -mol_0_center
	  rotate <10, 20, 0>
	  translate mol_0_center
	 }
