#ifndef PAIR_SOURCE_HPP
#define PAIR_SOURCE_HPP

#include <pair/SourceBase.hpp>

namespace pair {

/// Counts.
/// Ports, properties and attributes are members of the base class: SourceBase, generated from pair.xml.
class Source : public SourceBase {
public:
    explicit Source(const std::string& name);
    ~Source() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

}  // namespace pair

#endif
