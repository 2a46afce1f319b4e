// Frame 1 of 1. Render with: povray +Lpovinc +W16 +H16 frame_0001.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 0;   // seconds
#declare Frond_Loop = 0.04167;   // seconds, the length of the film
#include "frond_studio.inc"
#include "frond_vessel.inc"
Studio_Globals()
Studio_Room(<0,0.5,-1.5>,<0,0.1,0>,srgb<0.87,0.86,0.83>,1.5,rgb <0.656412,0.63951,0.590338>)
Studio_Lamp(<0,0.5,-1.5>,<0,0.1,0>,<-1.159539,1.739308,-1.546052>,rgb <1.28,1.2288,1.152>,0.672,2)
Studio_Lamp(<0,0.5,-1.5>,<0,0.1,0>,<1.427125,1,-1.070343>,rgb <0.2236,0.2418,0.26>,0,0)
Studio_Lamp(<0,0.5,-1.5>,<0,0.1,0>,<0,3,-0.4>,rgb <0.3264,0.3332,0.34>,4,1)
Studio_Lamp(<0,0.5,-1.5>,<0,0.1,0>,<0.891953,1.4,0.7>,rgb <0.22,0.2156,0.209>,0,0)
camera{location<0,5,-15> right x*image_width/image_height angle 45 look_at<0,1,0>}
// The skins, old and young.
#declare Skin = array[1];
#declare Skin_Pigment = array[1][2];

// banded
#declare Solid0_0 = mesh2{
vertex_vectors{428,<0,0.042,0>,<0.404,0.042,0>,<0.1248,0.042,0.3842>,<-0.3268,0.042,0.2375>,<-0.3268,0.042,-0.2375>,<0.1... (9190 characters, fb28f1476bf04ffa)
normal_vectors{428,<0,-1,0>,<-0.085,-0.996,-0.02>,<-0.007,-0.996,-0.088>,<0.081,-0.996,-0.033>,<0.057,-0.996,0.067>,<-0.... (8926 characters, 430882438d8b36a3)
uv_vectors{428,<0.5,0.013>,<0,0.013>,<0.2,0.013>,<0.4,0.013>,<0.6,0.013>,<0.8,0.013>,<1,0.013>,<0,0.006>,<0.2,0.006>,<0.... (4753 characters, 5de038b05406e341)
face_indices{710      ,<0,1,2>,<0,2,3>,<0,3,4>,<0,4,5>,<0,5,6>,<1,8,2>,<1,7,8>,<2,9,3>,<2,8,9>,<3,10,4>,<3,9,10>,<4,11,5... (9424 characters, ebac8ac55b7d1652)
object{Solid0_0  texture{Vessel_Ceramic(srgb<0.6005,0.6974,0.6199>,srgb<0.5036,0.3874,0.2906>,0.33155,0.5,0,0.8)}texture{Vessel_Band(srgb<0.12,0.18,0.42>,0.6,0.06,0.8,4,24)}texture{Vessel_Band(srgb<0.12,0.18,0.42>,0.2,0.06,0.8,3,24)}matrix<0.04714,0,-0.99889,0,1,0,0.99889,0,0.04714,0,0,0>}
// glass
#declare Solid1_0 = mesh2{
vertex_vectors{357,<0,0.042,0>,<0.404,0.042,0>,<0,0.042,0.404>,<-0.404,0.042,0>,<0,0.042,-0.404>,<0.404,0.042,0>,<0.404,... (6339 characters, b91e2935e8fe668d)
normal_vectors{357,<0,-1,0>,<-0.085,-0.996,-0.028>,<0.028,-0.996,-0.085>,<0.085,-0.996,0.028>,<-0.028,-0.996,0.085>,<-0.... (7442 characters, 88271b4f3af9daa6)
uv_vectors{357,<0.5,0.013>,<0,0.013>,<0.25,0.013>,<0.5,0.013>,<0.75,0.013>,<1,0.013>,<0,0.006>,<0.25,0.006>,<0.5,0.006>,... (4062 characters, 044499a10b1078ab)
face_indices{568      ,<0,1,2>,<0,2,3>,<0,3,4>,<0,4,5>,<1,7,2>,<1,6,7>,<2,8,3>,<2,7,8>,<3,9,4>,<3,8,9>,<4,10,5>,<4,9,10>... (7454 characters, bad8d260d9c250f4)
object{Solid1_0  texture{Vessel_Glass(srgb<0.62,0.72,0.64>,srgb<0.4938,0.3799,0.2849>,0.33155,0.5,0,0.8)}interior{Vessel_Glass_Inside(srgb<0.62,0.72,0.64>,srgb<0.4938,0.3799,0.2849>,0.33155,0.5,0,0.8)}matrix<0.33007,0,-0.94396,0,1,0,0.94396,0,0.33007,4,0,0>}
// turned
#declare Solid2_0 = lathe{bezier_spline 132,<0,0.042>,<0.13938,0.042>,<0.26462,0.042>,<0.404,0.042>,<0.404,0.042>,<0.404... (2474 characters, f55919a8baa8dd97)
object{Solid2_0  texture{Vessel_Terracotta(srgb<0.6041,0.7016,0.6236>,srgb<0.5067,0.3898,0.2923>,0.1099,0.5,0,0.8)}matrix<-0.91739,0,0.39799,0,1,0,-0.39799,0,-0.91739,-4,0,0>}



