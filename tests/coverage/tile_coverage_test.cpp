#include "tramline/coverage/tile_coverage.h"

#include <gtest/gtest.h>
