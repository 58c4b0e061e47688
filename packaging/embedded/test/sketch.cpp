// The main program of an Arduino core, which calls the sketch once.
#include "Arduino.h"

Port Serial;
void setup();

int main() {
    setup();
    return 0;
}
