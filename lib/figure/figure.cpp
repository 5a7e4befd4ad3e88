#include "lib/figure/figure.hpp"

#include <utility>

namespace loadpath::figure {

Plot::Plot() = default;
Plot::Plot(Scale across, Scale up) : x(std::move(across)), y(std::move(up)) {}
Plot::Plot(const Plot&) = default;
Plot::Plot(Plot&&) noexcept = default;
Plot& Plot::operator=(const Plot&) = default;
Plot& Plot::operator=(Plot&&) noexcept = default;
Plot::~Plot() = default;

Scheme::Scheme() = default;
Scheme::Scheme(const Scheme&) = default;
Scheme::Scheme(Scheme&&) noexcept = default;
Scheme& Scheme::operator=(const Scheme&) = default;
Scheme& Scheme::operator=(Scheme&&) noexcept = default;
Scheme::~Scheme() = default;

Figure::Figure(std::string name, std::string words, Plot drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Scheme drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Shaft drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Plans drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Motion drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Charted drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(std::string name, std::string words, Drawn drawn)
    : id(std::move(name)), caption(std::move(words)), content(std::move(drawn)) {}
Figure::Figure(const Figure&) = default;
Figure::Figure(Figure&&) noexcept = default;
Figure& Figure::operator=(const Figure&) = default;
Figure& Figure::operator=(Figure&&) noexcept = default;
Figure::~Figure() = default;

}  // namespace loadpath::figure
