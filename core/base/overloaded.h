// Several callables as one, for std::visit. Beside windows, not inside them: the tool that collects visible texts loses
// the class it is in behind such a template.
#pragma once

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>; // clang 14 does not deduce it by itself
