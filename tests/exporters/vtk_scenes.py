"""Scenes that VTK writes. Usage: vtk_scenes.py FOLDER"""
import pathlib
import sys

import vtk


def actor(source, **properties):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.Update()
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    for name, value in properties.items():
        getattr(made.GetProperty(), "Set" + name)(value)
    return made


def export(path, actors, spotlight=False):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    for one in actors:
        renderer.AddActor(one)
    lamp = vtk.vtkLight()
    lamp.SetPosition(3, 4, 6)
    lamp.SetPositional(spotlight)
    lamp.SetConeAngle(40)
    renderer.AddLight(lamp)
    renderer.GetActiveCamera().SetPosition(2, 3, 6)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.AddRenderer(renderer)
    window.SetSize(160, 120)
    exporter = vtk.vtkPOVExporter()
    exporter.SetRenderWindow(window)
    exporter.SetFileName(str(path))
    exporter.Write()


def through(made, source):
    made.SetInputConnection(source.GetOutputPort())
    return made


def main(folder):
    ball = vtk.vtkSphereSource()
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(16)
    ball.SetRadius(1.2)
    box = vtk.vtkCubeSource()
    box.SetCenter(1.3, -0.3, 0.4)
    glass = actor(through(vtk.vtkTriangleFilter(), box), Opacity=0.4, Color=(0.9, 0.2, 0.1), Specular=0.5, SpecularPower=30.0)
    moved = actor(ball, Color=(0.3, 0.8, 0.4), Ambient=0.1, Diffuse=0.8)
    moved.SetPosition(-0.5, 0.2, 0)
    moved.SetScale(1, 0.7, 1)
    export(folder / "vtk_plain.pov", [moved, glass])
    export(folder / "vtk_spotlight.pov", [moved, glass], spotlight=True)
    # Points have values, shown by colours that differ in their opacity too: textures at the corners of faces.
    height = through(vtk.vtkElevationFilter(), through(vtk.vtkStripper(), ball))
    height.SetLowPoint(0, -1.2, 0)
    height.SetHighPoint(0, 1.2, 0)
    colors = vtk.vtkLookupTable()
    colors.SetAlphaRange(0.2, 1)
    colors.Build()
    by_value = actor(height)
    by_value.GetMapper().SetLookupTable(colors)
    export(folder / "vtk_values.pov", [by_value])


main(pathlib.Path(sys.argv[1]))
