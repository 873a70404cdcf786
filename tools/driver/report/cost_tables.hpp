// SPDX-License-Identifier: MIT
// A study of cost as tables of words: what the report for people and the page share.
#pragma once

#include <string>
#include <vector>

#include "renderer/cost/report.hpp"

namespace cobble::driver {

struct CostColumn {
    std::string title;
    bool words = false;  ///< set left, and may be broken into lines; else numbers, set right
};

struct CostTable {
    std::string id;                              ///< one word: "curve"
    std::string title;                           ///< "error over time"
    std::string lead;                            ///< what the numbers are; one or two sentences
    std::vector<CostColumn> columns;             ///< the first names its row
    std::vector<std::vector<std::string>> rows;  ///< one text a column; empty if nothing is there
    std::vector<std::string> notes;              ///< what follows from the numbers; sentences
    std::string missing;                         ///< why there are no rows
};

CostTable curve_table(const renderer::CostReport& report);
CostTable stage_table(const renderer::CostReport& report);
CostTable effect_table(const renderer::CostReport& report);
CostTable noise_table(const renderer::CostReport& report);
CostTable precision_table(const renderer::CostReport& report);
CostTable bias_table(const renderer::CostReport& report);
CostTable rung_table(const renderer::CostReport& report);

/// "float" or "double".
std::string precision_name(renderer::Precision precision);

/// Its name, or "4 samples" if it has none; ", double" behind it where it is.
std::string rung_name(const renderer::Rung& rung);

/// "a.scene, 640x480, 2 threads, seed 0", made safe to print.
std::string cost_subject(const renderer::CostReport& report);

/// "studied for 58.2 s", or that it is not known.
std::string cost_study_time(const renderer::CostReport& report);

/// The recommendation, or that there is none.
std::string cost_recommendation(const renderer::CostReport& report);

}  // namespace cobble::driver
