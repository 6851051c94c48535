import { placeFor, withoutSensor, withSensor } from '@botgarten/simulation'
import type { MotorPort, RobotConfig, SensorKind, SensorPlace, SensorPort } from '@botgarten/simulation'
import type { LabSession } from '#lab/session.svelte.ts'
import { isOnRobot, movedTo, type Spot } from './placing.ts'
import { freePort, movedOver } from './ports.ts'

/** The robot that is being built, and which of its parts is chosen. Every change is one step, and in effect at once. */
export class RobotBuilder {
  readonly #session: LabSession
  #sensor = $state<SensorPort | null>(null)
  #motor = $state<MotorPort | null>(null)
  #full = $state(false)

  constructor(session: LabSession) {
    this.#session = session
  }

  get config(): RobotConfig {
    return this.#session.config
  }

  /** The port of the sensor that is chosen. */
  get sensor() {
    return this.#sensor
  }
  get motor() {
    return this.#motor
  }
  /** Was there no free port for the last sensor? */
  get full() {
    return this.#full
  }

  change = (next: RobotConfig): void => {
    this.#session.apply({ kind: 'config', id: this.#session.robotId, after: next })
  }

  put = (port: SensorPort, place: SensorPlace): void => this.change(withSensor(this.config, port, place))

  select = (port: SensorPort | null): void => {
    this.#sensor = port
    this.#motor = null
  }

  selectMotor = (port: MotorPort): void => {
    this.#sensor = null
    this.#motor = port
  }

  /** At the first port that is free. */
  take = (kind: SensorKind): void => this.#plug(freePort(this.config), placeFor(kind, this.config))

  /** Let go of over a port, it is plugged in there; over the robot, it sits at that place. Elsewhere it goes back. */
  drop(kind: SensorKind, port: SensorPort | undefined, spot: Spot | undefined): void {
    const place = placeFor(kind, this.config)
    if (port) this.#plug(port, place)
    else if (spot && isOnRobot(spot)) this.#plug(freePort(this.config), movedTo(place, spot))
  }

  /** Plugs the chosen sensor over to another port. */
  moveOver = (to: SensorPort): void => {
    if (this.#sensor !== null) this.change(movedOver(this.config, this.#sensor, to))
    this.#sensor = to
  }

  remove = (port: SensorPort): void => {
    this.change(withoutSensor(this.config, port))
    this.#sensor = null
    this.#full = false
  }

  #plug(port: SensorPort | null, place: SensorPlace): void {
    this.#full = port === null
    if (port === null) return
    this.put(port, place)
    this.select(port)
  }
}
