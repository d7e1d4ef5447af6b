#pragma once
#define NEEDY_AXES 3
