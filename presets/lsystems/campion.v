angle increment: 45
initial color: 1
color increment: 1
initial line width: 0.5 cylinders
line width increment: 0
contour sides: 8
viewpoint: 0,3,10
view reference point: 0,2,0
viewing angle: 30
surface: l lance_leaf.s 1
surface: p notched_petal.s 1
function set: growth.fset
