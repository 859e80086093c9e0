#include "syntax/names.h"

#include <algorithm>

namespace rt {

namespace {

const VariablePtr nothing;

}  // namespace

const VariablePtr& Names::find(std::string_view name) const {
    const auto found = table_.find(name);
    return found == table_.end() || found->second.empty() ? nothing : found->second.back().variable;
}

const VariablePtr& Names::find_from(std::size_t scope, std::string_view name) const {
    const auto found = table_.find(name);
    if (found == table_.end()) return nothing;
    const Bindings& all = found->second;
    const auto seen = std::find_if(all.rbegin(), all.rend(), [scope](const Binding& b) { return b.scope <= scope; });
    return seen == all.rend() ? nothing : seen->variable;
}

const VariablePtr& Names::find_in(std::size_t scope, std::string_view name) const {
    const auto found = table_.find(name);
    if (found == table_.end()) return nothing;
    const Bindings& all = found->second;
    const auto seen = std::find_if(all.rbegin(), all.rend(), [scope](const Binding& b) { return b.scope == scope; });
    return seen == all.rend() ? nothing : seen->variable;
}

void Names::bind(std::size_t scope, std::string_view name, VariablePtr variable) {
    auto found = table_.find(name);
    if (found == table_.end()) found = table_.emplace(std::string(name), Bindings()).first;
    Bindings& all = found->second;
    const auto place = std::lower_bound(all.begin(), all.end(), scope, [](const Binding& b, std::size_t s) { return b.scope < s; });
    if (place != all.end() && place->scope == scope) {
        place->variable = std::move(variable);
        return;
    }
    all.insert(place, {scope, std::move(variable)});
    if (scope > 0) bound_[scope - 1].push_back(&all);
}

bool Names::unbind(std::string_view name) {
    const auto found = table_.find(name);
    if (found == table_.end() || found->second.empty()) return false;
    const std::size_t scope = found->second.back().scope;
    found->second.pop_back();
    if (scope > 0) std::erase(bound_[scope - 1], &found->second);
    return true;
}

void Names::open_scope() {
    if (bound_.size() == depth_++) bound_.emplace_back();
}

void Names::close_scope() {
    for (Bindings* bindings : bound_[depth_ - 1]) bindings->pop_back();
    bound_[--depth_].clear();
}

}  // namespace rt
