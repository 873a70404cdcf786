// SPDX-License-Identifier: MIT
#include "frontend/ast/views.hpp"
