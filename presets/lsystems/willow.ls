# A weeping willow: shoots hang by their own weight.
15      # recursion
25      # angle
16      # thickness, % of length
T       # axiom
# A short trunk and its limbs, which fork once.
T=FF~(5)F[&(34)B]>(97)!(0.9)F[&(26)B]>(135)[&(38)B]>(101)!(0.8)F[&(20)B]>(125)[&(30)B]>(140)&(8)B
B=!(0.7)F~(9)FF[&(16)+(26)E]&(4)-(16)E
# A limb arches over and carries shoots on both sides.
E=!(0.87)'(0.97)F~(11)$t(0.14)[+(40)C][-(40)C][&(30)C]E
C=!(0.4)'(0.62)S
S=F$t(0.4)~(7)[+(38)L][-(38)L]'(0.97)S
# Blades like lances.
L=[&(12){.+(11)f(38)-(11)f(34)-(11)f(44)-(158)f(44)-(11)f(34)}]
@
