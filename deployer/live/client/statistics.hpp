// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_STATISTICS_HPP
#define OROFORGE_LIVE_CLIENT_STATISTICS_HPP

#include <cstddef>

namespace oroforge::live_client {

/** Least, greatest, mean and standard deviation of numbers, in one pass (Welford). */
class Statistics {
public:
    void add(double value);

    std::size_t count() const { return count_; }
    double least() const { return least_; }
    double greatest() const { return greatest_; }
    double mean() const { return mean_; }
    double deviation() const;

private:
    std::size_t count_ = 0;
    double least_ = 0, greatest_ = 0, mean_ = 0, squares_ = 0;
};

}  // namespace oroforge::live_client

#endif
