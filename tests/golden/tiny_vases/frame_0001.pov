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
vertex_vectors{200,<0,0.042,0>,<0.1307,0,0.4022>,<0.4229,0,0>,<-0.3421,0,0.2486>,<-0.3421,0,-0.2486>,<0.1307,0,-0.4022>,... (4365 characters, e3a9912b20c838c7)
normal_vectors{200,<0,-1,0>,<-0.121,-0.972,-0.2>,<-0.246,-0.966,0.082>,<0.153,-0.972,-0.177>,<0.216,-0.972,0.091>,<-0.02... (4193 characters, efa2d353e127d5d4)
uv_vectors{200,<0.5,0.013>,<0.2,0>,<0,0>,<0.4,0>,<0.6,0>,<0.8,0>,<1,0>,<0.6,0.201>,<0.8,0.201>,<0,0.201>,<1,0.201>,<0.2,... (2164 characters, 04588565469ebc47)
face_indices{92       ,<0,2,1>,<0,1,3>,<0,3,4>,<0,4,5>,<0,5,6>,<58,7,59>,<60,8,61>,<62,7,8>,<63,8,64>,<65,9,66>,<8,10,67... (1107 characters, 6f97a72fd3fd49c1)
object{Solid0_0  texture{Vessel_Ceramic(srgb<0.6005,0.6974,0.6199>,srgb<0.5036,0.3874,0.2906>,0.33155,0.5,0,0.8)}texture{Vessel_Band(srgb<0.12,0.18,0.42>,0.6,0.06,0.8,4,24)}texture{Vessel_Band(srgb<0.12,0.18,0.42>,0.2,0.06,0.8,3,24)}matrix<0.04714,0,-0.99889,0,1,0,0.99889,0,0.04714,0,0,0>}
// glass
#declare Solid1_0 = mesh2{
vertex_vectors{214,<0,0.042,0>,<0,0.0057,0.4943>,<0.5,0.06,0>,<-0.4943,0.0057,0>,<0,0.0057,-0.4943>,<0.5,0.06,0>,<0,0.66... (3886 characters, d612c800a241cfd2)
normal_vectors{214,<0,-1,0>,<-0.098,-0.702,0.706>,<0.74,-0.672,-0.037>,<-0.706,-0.702,-0.098>,<0.098,-0.702,-0.706>,<0.7... (4505 characters, 7caf36ee42437997)
uv_vectors{214,<0.5,0.013>,<0.25,0.002>,<0,0.018>,<0.5,0.002>,<0.75,0.002>,<1,0.018>,<0.25,0.201>,<0,0.25>,<0.5,0.25>,<0... (2545 characters, 8d48e12dafe8ca43)
face_indices{68       ,<0,45,44>,<0,47,46>,<0,49,48>,<0,51,50>,<52,54,53>,<1,56,55>,<57,59,58>,<60,62,61>,<3,64,63>,<3,6... (876 characters, 20dd610f2770b80b)
object{Solid1_0  texture{Vessel_Glass(srgb<0.62,0.72,0.64>,srgb<0.4938,0.3799,0.2849>,0.33155,0.5,0,0.8)}interior{Vessel_Glass_Inside(srgb<0.62,0.72,0.64>,srgb<0.4938,0.3799,0.2849>,0.33155,0.5,0,0.8)}matrix<0.33007,0,-0.94396,0,1,0,0.94396,0,0.33007,4,0,0>}
// turned
#declare Solid2_0 = lathe{bezier_spline 132,<0,0.042>,<0.13938,0.042>,<0.26462,0.042>,<0.404,0.042>,<0.404,0.042>,<0.404... (2474 characters, f55919a8baa8dd97)
object{Solid2_0  texture{Vessel_Terracotta(srgb<0.6041,0.7016,0.6236>,srgb<0.5067,0.3898,0.2923>,0.1099,0.5,0,0.8)}matrix<-0.91739,0,0.39799,0,1,0,-0.39799,0,-0.91739,-4,0,0>}



