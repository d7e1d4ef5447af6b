#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/TypekitRepository.hpp>

class Own : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override { return true; }
    bool loadOperators() override { return true; }
    bool loadConstructors() override { return true; }
    std::string getName() override { return "own"; }
};

ORO_TYPEKIT_PLUGIN(Own)
