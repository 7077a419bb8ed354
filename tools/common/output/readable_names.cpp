// SPDX-License-Identifier: Apache-2.0

#include "readable_names.h"

#include <fmt/format.h>

#include <cctype>
#include <map>

namespace wellstrat::cli {
namespace {

const std::map<std::string, std::string>& titles() {
    static const std::map<std::string, std::string> all{
        {"pmj", "Stratified"},
        {"joint", "Stratified jointly"},
        {"long", "Stratified, long"},
        {"blue", "Stratified, blue noise"},
        {"random", "Random"},
        {"sobol", "Sobol"},
        {"sobol-owen", "Owen-scrambled Sobol"},
        {"sobol-shift", "Shifted Sobol"},
        {"halton", "Halton"},
        {"jitter", "Jittered"},
        {"zsobol", "ZSobol"},
        {"tile", "Annealed tile"},
    };
    return all;
}

} // namespace

std::string generatorTitle(const std::string& name) {
    const auto found = titles().find(name);
    if (found != titles().end()) return found->second;
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) return name;
    const std::string kind = name.substr(0, colon), rest = name.substr(colon + 1);
    if (kind == "file") return rest.substr(rest.rfind('/') + 1);
    const auto ofKind = titles().find(kind);
    return ofKind == titles().end() ? name : ofKind->second + ", slots " + rest;
}

std::string integrandTitle(const std::string& name) {
    std::string title;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (c == '*')
            title += " times ";
        else if (c == '-')
            title += ' ';
        else if (c == '^')
            title += fmt::format(" in {} domains", name.substr(++i, 1));
        else
            title += c == 'd' && i > 0 && std::isdigit(name[i - 1]) != 0 ? 'D' : c;
    }
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

} // namespace wellstrat::cli
