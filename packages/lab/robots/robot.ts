import type { Robot } from '@botgarten/blocks'
import {
  arrived,
  clearDisplay,
  display,
  encoder,
  isPressed,
  resetEncoder,
  resetGyro,
  resetTimer,
  setLed,
  setMotor,
  startMove,
  stopMotors,
  timer,
  tone,
  type Simulation,
} from '@botgarten/simulation'

/** A robot of the simulation as a block may touch it. */
export function robotOf(simulation: Simulation, index: number): Robot {
  const { config } = simulation.world.robots[index]!
  return {
    read: (port, mode) => simulation.read(index, port, mode),
    motor: (port, percent) => setMotor(simulation, index, port, percent),
    move: (order) => startMove(simulation, index, order),
    arrived: () => arrived(simulation, index),
    stop: () => stopMotors(simulation, index),
    led: (colour) => setLed(simulation, index, colour),
    display: (row, column, text) => display(simulation, index, row, column, text),
    clearDisplay: () => clearDisplay(simulation, index),
    tone: (frequency, seconds) => tone(simulation, index, frequency, seconds),
    encoder: (port) => encoder(simulation, index, port),
    resetEncoder: (port) => resetEncoder(simulation, index, port),
    timer: (number) => timer(simulation, index, number),
    resetTimer: (number) => resetTimer(simulation, index, number),
    resetGyro: (port) => resetGyro(simulation, index, port),
    key: (key) => isPressed(simulation, index, key),
    wheelDiameter: config.wheelDiameter,
    trackWidth: config.trackWidth,
  }
}
