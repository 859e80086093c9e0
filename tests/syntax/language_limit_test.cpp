// Scenes that would never end, or never fit, end with a limit that is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/syntax/read_scene.h"

namespace rt::language_limit_test {
namespace {

std::string limit_text(const std::string& scene, const ParseOptions& options, const Files& files = {}) {
    const Outcome o = read_scene(scene, options, files);
    EXPECT_TRUE(o.limit) << scene << o.error;
    return o.error;
}

TEST(LanguageLimit, EndlessLoopsEnd) {
    ParseOptions options;
    options.max_replayed_bytes = 100'000;
    const std::string text = "Loops and macros have read more than 100000 bytes of text again. --limit reread=N allows more.";
    for (const char* scene :
         {"#while(1) #end", "#while(1) #if(1) #else #end #end", "#for(I,0,1e300) #end", "#for(I,0,0) #declare I=-1; #end",
          "#while(1) #while(0) #end #end", "#macro M() #end #while(1) M() #end", "sphere { #while(1) #end 0, 1 }",
          "#declare A = (1 #while(1) + 1 #end);", "#declare A = array[1000] #for(I,1,10) #declare B = A #end"})
        EXPECT_THAT(limit_text(scene, options), testing::HasSubstr(text)) << scene;
    EXPECT_EQ(read_scene("#for(I,1,100) sphere { 0, 1 } #end", options).error, "");
}

TEST(LanguageLimit, EndlessRecursionsEnd) {
    ParseOptions options;
    options.max_macro_depth = 500;
    const std::string text = "Macros call each other more than 500 deep. --limit macro-depth=N allows more.";
    for (const char* scene :
         {"#macro M() M() #end M()", "#macro A() B() #end #macro B() A() #end A()", "#macro M(n) #if(1) M(n+1) #end #end M(0)"})
        EXPECT_THAT(limit_text(scene, options), testing::HasSubstr(text)) << scene;
    EXPECT_EQ(read_scene("#macro R(n) #if(n>0) R(n-1) #end #end R(490)", options).error, "");
    // These need the stack as well: that may be what ends them.
    const ParseOptions defaults;
    for (const char* scene :
         {"#macro F() #local r = F(); r #end #declare A = F();", "#macro F() (1+F()) #end #declare A = F();",
          "#macro F(a) F(F(a)) #end F(1)", "#macro F() <F(),1> #end sphere { F(), 1 }", "#macro F() #if(F()) #end #end F()",
          "#macro F() object { F() } #end F()", "#declare A=array[1]{1} #macro F() A[F()] #end sphere { 0, F() }"})
        limit_text(scene, defaults);
}

TEST(LanguageLimit, RecursionThroughValuesIsAsDeepAsTheStackAllows) {
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr int deep = 1000;
#else
    constexpr int deep = 100;
#endif
    const std::string sum = "#macro F(n) #local r = 0; #if(n>0) #local r = 1 + F(n-1); #end r #end #declare A = F({}); #debug str(A,0,0)";
    EXPECT_EQ(debug_text(fmt::format(fmt::runtime(sum), deep)), std::to_string(deep));
}

TEST(LanguageLimit, ArraysAndFilesAreLimited) {
    ParseOptions options;
    options.max_array_elements = 1000;
    options.max_written_bytes = 1000;
    EXPECT_THAT(limit_text("#declare A=array[1001]", options),
                testing::HasSubstr("An array has more than 1000 elements. --limit array=N allows more."));
    EXPECT_THAT(limit_text("#declare A=array[100][100]", options),
                testing::HasSubstr("An array has more than 1000 elements. --limit array=N allows more."));
    limit_text("#declare A=array[2147483647][2147483647][2147483647][2147483647][4]", options);
    EXPECT_EQ(read_scene("#declare A=array[10][100]", options).error, "");
    EXPECT_THAT(limit_text("#declare A=array[1]{1} #for(I,0,999) #declare B=array[1]{A} #declare A=B #end", options),
                testing::HasSubstr("Arrays hold arrays more than 100 deep."));
    EXPECT_THAT(limit_text("#macro Push(P,N) #if(N) #declare P=array[1]{0} Push(P[0],N-1) #end #end "
                           "#declare A=array[1]{0} Push(A[0],200) #declare B=A",
                           options),
                testing::HasSubstr("Arrays hold arrays more than 100 deep."));
    EXPECT_THAT(limit_text("#declare A=array[3]{1,2,3} #macro Set(P) #declare P=A; #end #while(1) Set(A[0]) #end", options),
                testing::HasSubstr("Arrays hold arrays more than 100 deep."));
    EXPECT_THAT(limit_text("#fopen F \"o\" write #while(1) #write(F,\"0123456789\") #end", options),
                testing::HasSubstr("The scene writes more than 1000 bytes. --limit written=N allows more."));
    limit_text("#fopen F \"o\" write #write(F,\"0123456789\") #while(1) #fopen G \"o\" read #end", options);
}

TEST(LanguageLimit, ElementsOfArraysInArraysCountWhenTheyAreCopied) {
    ParseOptions options;
    options.max_replayed_bytes = 100'000;
    std::string scene = "#declare A0 = array[1] { 1 }\n";
    for (int i = 0; i < 60; ++i) scene += fmt::format("#declare A{1} = array[2] {{ A{0}, A{0} }}\n", i, i + 1);
    EXPECT_THAT(limit_text(scene, options), testing::HasSubstr("bytes of text again. --limit reread=N allows more.\n   9 | #declare A8"));
}

TEST(LanguageLimit, MemoryIsLookedAtWhileLoopsRun) {
    ParseOptions options;
    options.max_memory_bytes = 1'000'000;  // what every process has
    EXPECT_THAT(limit_text("#while(1) sphere { 0, 1 } #end", options),
                testing::HasSubstr("The scene takes more than 0.0 GB of memory. --limit memory=N allows more."));
    EXPECT_EQ(read_scene("sphere { 0, 1 }", options).error, "");
}

TEST(LanguageLimit, AChainOfFiftyIncludesIsNone) {
    Files files;
    for (int i = 0; i < 50; ++i)
        files[fmt::format("f{}", i)] = fmt::format("#local A = {0}; #include \"f{1}\" #debug str(A,0,0)\n", i, i + 1);
    files["f50"] = "#debug \"deep \"";
    EXPECT_THAT(debug_text("#include \"f0\"", {}, files), testing::StartsWith("deep 4948"));
}

}  // namespace
}  // namespace rt::language_limit_test
