import type { MotorPort, SensorPort } from '@botgarten/simulation'
import type { Block } from '../types.ts'

export const field = (block: Block, name: string, preset = ''): string => block.fields?.[name] ?? preset

const sensorPorts: ReadonlyMap<string, SensorPort> = new Map(
  (['1', '2', '3', '4'] as const).flatMap((port) => [
    [port, port],
    [`ULTRASONIC_PORT_${port}`, port],
  ]),
)
const motorPorts: ReadonlyMap<string, MotorPort> = new Map(
  (['A', 'B', 'C', 'D'] as const).flatMap((port) => [
    [port, port],
    [`MOTORPORT_${port}`, port],
  ]),
)

/** The sensor port a field names; undefined where a file names one that no robot has. */
export const sensorPortIn = (block: Block, name: string) => sensorPorts.get(field(block, name))
export const motorPortIn = (block: Block, name: string) => motorPorts.get(field(block, name))
