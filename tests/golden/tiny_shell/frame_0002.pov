// Frame 2 of 2. Render with: povray +Lpovinc +W16 +H16 frame_0002.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 1;   // seconds
#declare Frond_Loop = 2;   // seconds, the length of the film
#include "frond_studio.inc"
#include "frond_tree.inc"
#include "frond_shell.inc"
Studio_Globals()
Studio_Room(<0.1,0.15,-0.3>,<0,0.03,0>,srgb<0.87,0.86,0.83>,1.5,rgb <0.656412,0.63951,0.590338>)
Studio_Lamp(<0.1,0.15,-0.3>,<0,0.03,0>,<-1.159539,1.739308,-1.546052>,rgb <1.28,1.2288,1.152>,0.672,2)
Studio_Lamp(<0.1,0.15,-0.3>,<0,0.03,0>,<1.427125,1,-1.070343>,rgb <0.2236,0.2418,0.26>,0,0)
Studio_Lamp(<0.1,0.15,-0.3>,<0,0.03,0>,<0,3,-0.4>,rgb <0.3264,0.3332,0.34>,4,1)
Studio_Lamp(<0.1,0.15,-0.3>,<0,0.03,0>,<0.891953,1.4,0.7>,rgb <0.22,0.2156,0.209>,0,0)
camera{location<1,1.5,-3> right x*image_width/image_height angle 45 look_at<0,0.3,0>}
// The skins, old and young.
#declare Skin = array[1];
#declare Skin_Pigment = array[1][2];


#declare Solid0_0 = mesh2{
vertex_vectors{3068,<0.1356,0.3217,-0.0284>,<0.1305,0.3214,-0.0284>,<0.1254,0.3208,-0.0284>,<0.1204,0.3197,-0.0284>,<0.1... (72584 characters, b46f949988746aeb)
normal_vectors{3068,<0.003,0.203,0.979>,<-0.014,0.201,0.98>,<-0.033,0.201,0.979>,<-0.053,0.205,0.977>,<-0.076,0.211,0.97... (64562 characters, d58909daf5ce721e)
uv_vectors{3068,<0.003,0>,<0.015,0>,<0.028,0>,<0.041,0>,<0.054,0>,<0.066,0>,<0.079,0>,<0.092,0>,<0.104,0>,<0.117,0>,<0.1... (39380 characters, 8b480a36c9f07ac9)
face_indices{6048     ,<3066,0,1>,<0,73,1>,<1,73,74>,<73,146,74>,<74,146,147>,<146,219,147>,<147,219,220>,<219,292,220>,... (96427 characters, a405d77cf21d297c)
object{Solid0_0  texture{Shell_Porcelain("shell_HASH.png",srgb<0.93,0.87,0.76>,srgb<1.0566,1.0566,1.0566>,0.06,0.5,0,0.6)}matrix<-0.48706,-0.02915,0.78485,-0.00607,0.92363,0.03054,-0.78537,0.01094,-0.48697,0,0,0>}


