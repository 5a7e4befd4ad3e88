// What a planar mechanism says in a report: its model, extremes, reactions, proof, figures.
#pragma once

#include "calculators/mechanism/planar_cycle.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/project/step.hpp"

#include <string>
#include <vector>

namespace loadpath {

/// Links, joints, drives and loads as tables.
std::vector<account::Block> model_tables(const PlanarMechanism::Input& in);
/// Largest and smallest of drives and reactions over the cycle, or the reactions at the one position; the groups that
/// the mechanism is built of, and how well the equations determine it.
std::vector<account::Block> result_tables(const account::Account& account, const mechanism::Model& model,
                                          const mechanism::Structure& structure, const Cycle& cycle, const Axis* axis);
/// Whether it closes everywhere; the equilibrium of every link and the power balance; the forces found again by other
/// methods, and the positions that are not trustworthy.
std::vector<account::Verdict> proof(const std::string& step, const PlanarMechanism::Input& in,
                                    const mechanism::Model& model, const Cycle& cycle, const Axis* axis);
/// The mechanism at the first position, at each of up to 12 given angles, and where the drive is largest; drive and
/// reactions over the cycle.
std::vector<draw::Figure> mechanism_figures(const PlanarMechanism::Input& in, const mechanism::Model& model,
                                            const Cycle& cycle, const account::Account& account, const Axis* axis);

/// The position nearest to the largest moment of the drive, or force of the first cylinder; else the first that has
/// forces; one past the last where none has.
std::size_t governing_position(const Cycle& cycle, const account::Account& account);

}  // namespace loadpath
