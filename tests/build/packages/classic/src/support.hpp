#pragma once
int classicAnswer();
