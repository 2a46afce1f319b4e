// Frame 1 of 1. Render with: povray +Lpovinc +RFI +RFlight_97e406953b58cc2c.rca +W320 +H240 frame_0001.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 0;   // seconds
#declare Frond_Loop = 0.04167;   // seconds, the length of the film
#include "frond_meadow.inc"
#include "frond_stone.inc"
Meadow_Globals()
Meadow_Setting(<0,1.2,-5>,<0.0397,0.1706,0.5705>,<0.6038,0.7484,0.8481>,srgb<0.39,0.46,0.17>,<0.6189,0.722,0.3094>,<3,2.79,2.34>,<0,0,0>,<1,1,1>,100000,0)
camera{location<0,12,-50> right x*image_width/image_height angle 45 look_at<0,6,0>}
// The skins, old and young.
#declare Skin = array[1];
#declare Skin_Pigment = array[1][2];

object{
mesh2{
vertex_vectors{24201,<0,0,0>,<0.124,0,-0.0018>,<0.1239,0,-0.0053>,<0.1237,0,-0.0088>,<0.1233,0,-0.0124>,<0.1229,0,-0.015... (528819 characters, fb869dda2f5d4710)
normal_vectors{24201,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,1,0>,<0,... (193629 characters, e1438b8f5b2566f1)
face_indices{48180    ,<0,1,2>,<0,2,3>,<0,3,4>,<0,4,5>,<0,5,6>,<0,6,7>,<0,7,8>,<0,8,9>,<0,9,10>,<0,10,11>,<0,11,12>,<0,1... (896656 characters, 9458e888a5bc37b3)
texture{Meadow_Ground(srgb<0.39,0.46,0.17>)}}
// large
#declare Solid0_0 = mesh2{
vertex_vectors{41692,<-2.6544,0,4.1098>,<-2.586,0,4.1595>,<-2.5838,0,4.1226>,<-2.166,0,4.1479>,<-2.0999,0,4.169>,<-2.095... (919558 characters, d041fdeed17a3537)
normal_vectors{41692,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,<0,-1,0>,... (718058 characters, 07ce0cc7d75f51cc)
face_indices{83380    ,<0,2,1>,<3,5,4>,<6,34297,7>,<7,34297,8>,<8,34297,9>,<9,34297,10>,<10,34297,11>,<11,34297,6>,<12,1... (1598877 characters, 0f146468d7b02c53)
object{Solid0_0  texture{Stone_Granite(srgb<0.5995,0.5608,0.5221>,srgb<0.2611,0.2514,0.2514>,0.12,0.5,0,0.12)}matrix<-0.6432,-0.05349,-1.00555,-0.05095,1.19337,-0.03089,1.00568,0.02624,-0.64468,-7.9762,-0.5568,0.0144>}
// small
#declare Solid1_0 = mesh2{
vertex_vectors{43237,<-0.5033,0.3766,2.9587>,<-0.4743,0.3646,3.009>,<-0.4749,0.3339,2.9653>,<-0.3387,0.3507,3.1668>,<-0.... (987565 characters, 6e4033cb07d0d772)
normal_vectors{43237,<-0.811,-0.43,0.397>,<-0.79,-0.462,0.403>,<-0.704,-0.623,0.34>,<-0.541,-0.666,0.513>,<-0.602,-0.634... (818846 characters, 77f09b5da40bbd5e)
face_indices{86457    ,<0,2,1>,<3,5,4>,<6,35610,7>,<7,35610,8>,<8,35610,9>,<9,35610,10>,<10,35610,6>,<11,35611,8>,<8,356... (1660204 characters, f47a7c318f797889)
object{Solid1_0  texture{Stone_Granite(srgb<0.6083,0.5691,0.5298>,srgb<0.2649,0.2551,0.2551>,0.12,0.5,0,0.12)}matrix<-0.84309,0.0786,0.17618,0.07493,0.86125,-0.02567,-0.17777,-0.00976,-0.84636,8.9742,-0.2966,3.0088>}



