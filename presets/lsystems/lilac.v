angle increment: 45
initial color: 10
color increment: 1
initial line width: 0.7 cylinders
viewpoint: 0,2,10
view reference point: 0,1,0
viewing angle: 30
surface: q lilac_petal.s 1
surface: h heart_leaf.s 1
function set: growth.fset
