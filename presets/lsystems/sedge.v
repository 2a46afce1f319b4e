angle increment: 45
initial color: 1
color increment: 1
initial line width: 0.3 cylinders
contour: 1 fold.con
contour sides: 8
tropism direction: 0,-1,0
initial elasticity: 0
viewpoint: 0,2,10
view reference point: 0,1,0
function set: growth.fset
