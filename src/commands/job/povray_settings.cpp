#include "commands/job/povray_settings.h"

#include "commands/base/values.h"

namespace rt {

namespace {

using Kind = PovraySetting::Kind;

constexpr PovraySetting settings[] = {
    {"Input_File_Name", Kind::value, "--input"},
    {"Output_File_Name", Kind::value, "--povray-output"},
    {"Output_to_File", Kind::boolean, "--output-to-file"},
    {"Output_File_Type", Kind::value, "--povray-type"},
    {"Bits_Per_Color", Kind::whole, "--bits"},
    {"Bits_Per_Colour", Kind::whole, "--bits"},
    {"Output_Alpha", Kind::boolean, "--output-alpha"},
    {"Width", Kind::whole, "--width"},
    {"Height", Kind::whole, "--height"},
    {"Start_Column", Kind::value, "--start-column"},
    {"End_Column", Kind::value, "--end-column"},
    {"Start_Row", Kind::value, "--start-row"},
    {"End_Row", Kind::value, "--end-row"},
    {"Antialias", Kind::boolean, "--antialias"},
    {"Antialias_Threshold", Kind::value, "--aa-threshold"},
    {"Antialias_Depth", Kind::whole, "--aa-depth"},
    {"Antialias_Gamma", Kind::value, "--aa-gamma"},
    {"Sampling_Method", Kind::whole, "--aa-method"},
    {"Jitter", Kind::boolean, "--jitter"},
    {"Jitter_Amount", Kind::value, "--jitter-amount"},
    {"Render_Block_Size", Kind::whole, "--aa-block"},
    {"Quality", Kind::whole, "--povray-quality"},
    {"Library_Path", Kind::value, "--library"},
    {"Work_Threads", Kind::whole, "--threads"},
    {"Version", Kind::value, "--language"},
    {"Declare", Kind::value, "--define"},
    {"File_Gamma", Kind::value, "--file-gamma"},
    {"Dither", Kind::boolean, "--dither"},
    {"Dither_Method", Kind::value, "--dither-method"},
    {"Clock", Kind::value, "--clock"},
    {"Initial_Clock", Kind::value, "--initial-clock"},
    {"Final_Clock", Kind::value, "--final-clock"},
    {"Initial_Frame", Kind::whole, "--initial-frame"},
    {"Final_Frame", Kind::whole, "--final-frame"},
    {"Subset_Start_Frame", Kind::value, "--subset-start-frame"},
    {"Subset_End_Frame", Kind::value, "--subset-end-frame"},
    {"Frame_Step", Kind::whole, "--frame-step"},
    {"Cyclic_Animation", Kind::boolean, "--cyclic-animation"},
    {"Include_Header", Kind::value, "--header"},
    {"All_Console", Kind::boolean, "--all-console"},
    {"Verbose", Kind::boolean, "--progress"},

    {"Grayscale_Output", Kind::unmodelled},
    {"Clockless_Animation", Kind::unmodelled},

    {"Field_Render", Kind::unavailable},  // nor does POV-Ray 3.7 render fields
    {"Display", Kind::unavailable},
    {"Pause_When_Done", Kind::unavailable},
    {"Continue_Trace", Kind::unavailable},
    {"Odd_Field", Kind::unavailable},
    {"Real_Time_Raytracing", Kind::unavailable},
    {"Draw_Vistas", Kind::unavailable},

    {"Bounding", Kind::always_on},
    {"High_Reproducibility", Kind::settled},
    {"Debug_Console", Kind::always_on},
    {"Fatal_Console", Kind::always_on},
    {"Warning_Console", Kind::always_on},
    {"Render_Console", Kind::settled},
    {"Statistic_Console", Kind::settled},

    {"All_File", Kind::ignored},
    {"Debug_File", Kind::ignored},
    {"Fatal_File", Kind::ignored},
    {"Render_File", Kind::ignored},
    {"Statistic_File", Kind::ignored},
    {"Warning_File", Kind::ignored},
    {"Append_File", Kind::ignored},
    {"Warning_Level", Kind::ignored},
    {"Bounding_Method", Kind::ignored},
    {"Bounding_Threshold", Kind::ignored},
    {"Light_Buffer", Kind::ignored},
    {"Vista_Buffer", Kind::ignored},
    {"Remove_Bounds", Kind::ignored},
    {"Split_Unions", Kind::ignored},
    {"BSP_BaseAccessCost", Kind::ignored},
    {"BSP_ChildAccessCost", Kind::ignored},
    {"BSP_IsectCost", Kind::ignored},
    {"BSP_MaxDepth", Kind::ignored},
    {"BSP_MissChance", Kind::ignored},
    {"Buffer_Output", Kind::ignored},
    {"Buffer_Size", Kind::ignored},
    {"Compression", Kind::ignored},
    {"Create_Ini", Kind::ignored},
    {"Display_Gamma", Kind::ignored},
    {"Histogram_Grid_Size", Kind::ignored},
    {"Histogram_Name", Kind::ignored},
    {"Histogram_Type", Kind::ignored},
    {"Max_Image_Buffer_Memory", Kind::ignored},
    {"Palette", Kind::ignored},
    {"Post_Frame_Command", Kind::command},
    {"Post_Frame_Return", Kind::ignored},
    {"Post_Scene_Command", Kind::command},
    {"Post_Scene_Return", Kind::ignored},
    {"Pre_Frame_Command", Kind::command},
    {"Pre_Frame_Return", Kind::ignored},
    {"Pre_Scene_Command", Kind::command},
    {"Pre_Scene_Return", Kind::ignored},
    {"Fatal_Error_Command", Kind::command},
    {"Fatal_Error_Return", Kind::ignored},
    {"User_Abort_Command", Kind::command},
    {"User_Abort_Return", Kind::ignored},
    {"Preview_Start_Size", Kind::ignored},
    {"Preview_End_Size", Kind::ignored},
    {"Radiosity_File_Name", Kind::ignored},
    {"Radiosity_From_File", Kind::ignored},
    {"Radiosity_To_File", Kind::ignored},
    {"Radiosity_Vain_Pretrace", Kind::ignored},
    {"Render_Block_Step", Kind::ignored},
    {"Render_Pattern", Kind::ignored},
    {"Test_Abort", Kind::ignored},
    {"Test_Abort_Count", Kind::ignored},
    {"Video_Mode", Kind::ignored},
};

constexpr PovraySwitch switches[] = {
    {"A", "Antialias=on Antialias_Threshold=?", "Antialias=off Antialias_Threshold=?"},
    {"AG", "Antialias_Gamma=!", "Antialias_Gamma=!"},
    {"AM", "Sampling_Method=!", "Sampling_Method=!"},
    {"B", "Buffer_Output=on Buffer_Size=?", "Buffer_Output=off Buffer_Size=?"},
    {"BM", "Bounding_Method=!", "Bounding_Method=!"},
    {"BS", "Render_Block_Size=!", "Render_Block_Size=!"},
    {"C", "Continue_Trace=on", "Continue_Trace=off"},
    {"D", "Display=on Palette=?", "Display=off Palette=?"},
    {"EC", "End_Column=!", "End_Column=!"},
    {"EF", "Subset_End_Frame=!", "Subset_End_Frame=!"},
    {"EP", "Preview_End_Size=!", "Preview_End_Size=!"},
    {"ER", "End_Row=!", "End_Row=!"},
    {"F", "Output_to_File=on Output_File_Type=?", "Output_to_File=off Output_File_Type=?"},
    {"GA", "All_Console=on All_File=?", "All_Console=off All_File=?"},
    {"GD", "Debug_Console=on Debug_File=?", "Debug_Console=off Debug_File=?"},
    {"GF", "Fatal_Console=on Fatal_File=?", "Fatal_Console=off Fatal_File=?"},
    {"GI", "Create_Ini=!", "Create_Ini=!"},
    {"GP", "Append_File=on", "Append_File=off"},
    {"GR", "Render_Console=on Render_File=?", "Render_Console=off Render_File=?"},
    {"GS", "Statistic_Console=on Statistic_File=?", "Statistic_Console=off Statistic_File=?"},
    {"GW", "Warning_Console=on Warning_File=?", "Warning_Console=off Warning_File=?"},
    {"H", "Height=!", "Height=!"},
    {"HI", "Include_Header=!", "Include_Header=!"},
    {"HN", "Histogram_Name=!", "Histogram_Name=!"},
    {"HR", "High_Reproducibility=on", "High_Reproducibility=off"},
    {"HS", "Histogram_Grid_Size=!", "Histogram_Grid_Size=!"},
    {"HT", "Histogram_Type=!", "Histogram_Type=!"},
    {"I", "Input_File_Name=!", "Input_File_Name=!"},
    {"J", "Jitter=on Jitter_Amount=?", "Jitter=off Jitter_Amount=?"},
    {"K", "Clock=!", "Clock=!"},
    {"KC", "Cyclic_Animation=on", "Cyclic_Animation=off"},
    {"KF", "Final_Clock=!", "Final_Clock=!"},
    {"KFF", "Final_Frame=!", "Final_Frame=!"},
    {"KFI", "Initial_Frame=!", "Initial_Frame=!"},
    {"KI", "Initial_Clock=!", "Initial_Clock=!"},
    {"L", "Library_Path=!", "Library_Path=!"},
    {"MB", "Bounding=on Bounding_Threshold=?", "Bounding=off Bounding_Threshold=?"},
    {"MI", "Max_Image_Buffer_Memory=!", "Max_Image_Buffer_Memory=!"},
    {"MV", "Version=!", "Version=!"},
    {"O", "Output_File_Name=!", "Output_File_Name=!"},
    {"P", "Pause_When_Done=on", "Pause_When_Done=off"},
    {"Q", "Quality=!", "Quality=!"},
    {"R", "Antialias_Depth=!", "Antialias_Depth=!"},
    {"RF", "Radiosity_File_Name=!", "Radiosity_File_Name=!"},
    {"RFI", "Radiosity_From_File=on", "Radiosity_From_File=off"},
    {"RFO", "Radiosity_To_File=on", "Radiosity_To_File=off"},
    {"RP", "Render_Pattern=!", "Render_Pattern=!"},
    {"RTR", "Real_Time_Raytracing=on", "Real_Time_Raytracing=off"},
    {"RVP", "Radiosity_Vain_Pretrace=on", "Radiosity_Vain_Pretrace=off"},
    {"SC", "Start_Column=!", "Start_Column=!"},
    {"SF", "Subset_Start_Frame=!", "Subset_Start_Frame=!"},
    {"SP", "Preview_Start_Size=!", "Preview_Start_Size=!"},
    {"SR", "Start_Row=!", "Start_Row=!"},
    {"SU", "Split_Unions=on", "Split_Unions=off"},
    {"TH", "Dither=on Dither_Method=?", "Dither=off Dither_Method=?"},
    {"UA", "Output_Alpha=on", "Output_Alpha=off"},
    {"UD", "Draw_Vistas=on", "Draw_Vistas=off"},
    {"UF", "Field_Render=on", "Field_Render=off"},
    {"UL", "Light_Buffer=on", "Light_Buffer=off"},
    {"UO", "Odd_Field=on", "Odd_Field=off"},
    {"UR", "Remove_Bounds=on", "Remove_Bounds=off"},
    {"UV", "Vista_Buffer=on", "Vista_Buffer=off"},
    {"V", "Verbose=on", "Verbose=off"},
    {"W", "Width=!", "Width=!"},
    {"WL", "Warning_Level=!", "Warning_Level=!"},
    {"WT", "Work_Threads=!", "Work_Threads=!"},
    {"X", "Test_Abort=on Test_Abort_Count=?", "Test_Abort=off"},
};

}  // namespace

std::span<const PovraySetting> povray_settings() { return settings; }

std::span<const PovraySwitch> povray_switches() { return switches; }

const PovraySetting* find_povray_setting(std::string_view key) {
    const std::string wanted = lower_case(key);
    for (const PovraySetting& setting : settings)
        if (lower_case(setting.key) == wanted) return &setting;
    return nullptr;
}

const PovraySwitch* find_povray_switch(std::string_view text) {
    const std::string word = lower_case(text);
    const PovraySwitch* best = nullptr;
    for (const PovraySwitch& candidate : switches)
        if (word.starts_with(lower_case(candidate.letters)) && (!best || candidate.letters.size() > best->letters.size()))
            best = &candidate;
    return best;
}

}  // namespace rt
