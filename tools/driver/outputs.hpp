// SPDX-License-Identifier: MIT
// Whether what a command writes would destroy what it reads.
#pragma once

#include <string>
#include <vector>

namespace cobble::driver {

/// What speaks against writing `outputs` beside reading `inputs`: two outputs that are one file, or
/// an output that is an input. Files are told apart by device and inode, those that are not there
/// yet by folder and name, so that neither spelling nor links matter. Devices and pipes may be
/// named as often as one likes. Gives "" or what is wrong.
std::string check_distinct(const std::vector<std::string>& outputs,
                           const std::vector<std::string>& inputs);

}  // namespace cobble::driver
