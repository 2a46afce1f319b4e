#include "export/macros.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

const MacroFiles kFiles{
    {"frond_leaf.inc",
     "#ifndef (Leaf_Inc)\n#declare Leaf_Inc = version;\n#macro Leaf_Skin(C)\n"
     "  #if (C > 0) pigment { rgb C } #end\n  finish { diffuse 1 }\n#end\n"
     "#macro Leaf_Rib(C) rgb C #end\n#end\n"},
    {"frond_tree.inc", "#include \"frond_leaf.inc\"\n#macro Tree_Top(A, B) Leaf_Skin(A) #end\n"},
    {"frond_sea.inc", "#macro Sea_Blue() rgb z #end\n"}};

TEST(Macros, AreTakenWithWhatTheyNeedThemselves) {
  EXPECT_EQ(macros_used(kFiles, "texture{Tree_Top(1,2)}"), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(macros_used(kFiles, "Leaf_Rib(1)"), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(macros_used(kFiles, "Leaf_Ribs(1) Not_Tree_Top").empty());
}

TEST(Macros, ThoseCalledAreNamedWithTheirArguments) {
  EXPECT_EQ(macros_called(kFiles, "Tree_Top(1,2) Leaf_Rib(x)"),
            (std::set<std::string>{"Leaf_Rib(C)", "Tree_Top(A, B)"}));
}

TEST(Macros, WhatATextDoesNotReachIsNotAmongWhatItReaches) {
  std::string reached = macros_reached(kFiles, "texture{Tree_Top(1,2)}");
  EXPECT_NE(reached.find("#macro Tree_Top"), reached.npos);
  EXPECT_NE(reached.find("#macro Leaf_Skin"), reached.npos) << "by Tree_Top";
  EXPECT_EQ(reached.find("Leaf_Rib"), reached.npos);
  EXPECT_EQ(reached.find("Sea_Blue"), reached.npos);
  EXPECT_EQ(macros_reached(kFiles, "Not_Tree_Top"), "");
}

TEST(Macros, CommentsAreNotAmongWhatATextReaches) {
  MacroFiles commented = kFiles;
  commented[2].second = "// Of water.\n#macro Sea_Blue() // deep\n  // blue\n  rgb z #end\n";
  EXPECT_EQ(macros_reached(commented, "Sea_Blue()"), "#macro Sea_Blue()\n  rgb z #end\n");
}

TEST(Macros, GiveWayToAScenesOwn) {
  EXPECT_EQ(macros_text(kFiles, {0}),
            "#ifndef (Leaf_Inc)\n#declare Leaf_Inc = version;\n"
            "#ifndef (Leaf_Skin)\n#macro Leaf_Skin(C)\n  #if (C > 0) pigment { rgb C } #end\n"
            "  finish { diffuse 1 }\n#end\n#end\n"
            "#ifndef (Leaf_Rib)\n#macro Leaf_Rib(C) rgb C #end\n#end\n#end\n");
  EXPECT_EQ(macros_text(kFiles, {1}).find("#include"), std::string::npos);
}

}  // namespace
}  // namespace frond
