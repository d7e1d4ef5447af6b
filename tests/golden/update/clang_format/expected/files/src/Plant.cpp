#include "Plant.hpp"

namespace tank
{
Plant::Plant( const std::string& name ) : RTT::TaskContext( name )
{
    this->addPort("level", level_)
        .doc("How high the water stands in the tank");
    this->addOperation("fill", &Plant::fill, this,
                       RTT::ClientThread)
        .doc("Fills it up to a level, however long that "
             "takes, unless it is stopped.")
        .arg("level", "")
        .arg("tolerance", "");
    this->addOperation("drain", &Plant::drain, this,
                       RTT::ClientThread);
}

bool Plant::fill(double /*level*/,
                 const std::string& /*tolerance*/)
{
    return true;
}

void Plant::drain() { gain=0; }

void Plant::updateHook()
{
}

bool Plant::startHook()
{
    // Prepare for updateHook(). False keeps the component
    // stopped.
    return true;
}
}