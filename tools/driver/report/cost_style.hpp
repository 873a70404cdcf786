// SPDX-License-Identifier: MIT
// How the page of a study of cost looks.
#pragma once

#include <string>

namespace cobble::driver {

/// CSS without anything from elsewhere: light, dark where the reader prefers it, and for paper.
std::string cost_style();

}  // namespace cobble::driver
