#pragma once

#include "foliage/floral_diagram.h"
#include "foliage/inflorescence.h"
#include "preset/describe.h"

namespace frond {

void describe(Properties& v, MemberSide& s);
void describe(Properties& v, Marks& m);
void describe(Properties& v, Spiral& s);
void describe(Properties& v, Whorl& w);
void describe(Properties& v, Receptacle& r);
void describe(Properties& v, FloralDiagram& d);
void describe(Properties& v, Inflorescence& i);

/// What is wrong with a diagram beyond its ranges; places are relative to it.
Errors diagram_faults(const FloralDiagram& diagram);

}  // namespace frond
