// Frame 1 of 2. Render with: povray +Lpovinc +W16 +H16 frame_0001.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 0;   // seconds
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




