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
vertex_vectors{295,<-0.0257,0.314,-0.0048>,<-0.0837,0.3233,0.0377>,<0.0179,0.3744,-0.0284>,<0.0637,0.314,-0.0329>,<-0.03... (6991 characters, 141ec9d396a148fa)
normal_vectors{295,<0,0.606,-0.796>,<0.569,-0.283,0.772>,<0.003,0.207,0.978>,<0,0.99,0.142>,<-0.801,-0.022,0.599>,<0,-0.... (6066 characters, 9aeda39670ec18cd)
uv_vectors{295,<0.003,0.932>,<0.97,0.889>,<0.97,0.75>,<0.003,0.517>,<0.142,0.599>,<0.003,0.716>,<0.092,0.932>,<0.97,1>,<... (3790 characters, 22213fb6b2029d13)
face_indices{160      ,<87,88,1>,<89,90,4>,<0,7,6>,<8,92,91>,<2,12,11>,<93,95,94>,<96,97,1>,<98,100,99>,<1,101,14>,<102,... (1960 characters, f3ae31274fb2b781)
object{Solid0_0  texture{Shell_Porcelain("shell_HASH.png",srgb<0.93,0.87,0.76>,srgb<1.0566,1.0566,1.0566>,0.06,0.5,0,0.6)}matrix<-0.48706,-0.02915,0.78485,-0.00607,0.92363,0.03054,-0.78537,0.01094,-0.48697,0,0,0>}


