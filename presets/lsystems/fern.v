angle increment: 45
initial color: 1
color increment: 1
initial line width: 0.5 cylinders
viewpoint: 10,2,0
view reference point: 0,1,0
surface: f pinnule.s 1
function set: growth.fset
