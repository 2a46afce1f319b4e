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
Studio_Setting(<0.1,0.15,-0.3>,<0,0.03,0>,srgb<0.87,0.86,0.83>,1.5,<-0.6,0.9,-0.8>,rgb <1.28,1.2288,1.152>,1)
camera{location<1,1.5,-3> right x*image_width/image_height angle 45 look_at<0,0.3,0>}
// The skins, old and young.
#declare Skin = array[1];
#declare Skin_Pigment = array[1][2];




