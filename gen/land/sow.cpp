#include "land/sow.h"
