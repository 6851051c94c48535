import { content } from '@botgarten/content/files'
import {
  cardConfig,
  motorPorts,
  withMotors,
  type MotorPlug,
  type RobotConfig,
  type SensorPlace,
} from '@botgarten/simulation'
import fc from 'fast-check'
import { expect, it } from 'vitest'
import { xmlTree } from '../testing/xml-tree.ts'
import { robotIn, withRobot } from './brick.ts'
import { fileFrom, projectFrom, readOpenRoberta } from './index.ts'

const garden = content.world('garden')!

/** Open Roberta's configuration toolbox (`ev3.configuration.toolbox.xml`), and the sensor each is here. */
const sensors = [
  ['ultrasonic', 'ultrasonic'],
  ['colour', 'colour'],
  ['infrared', 'infrared'],
  ['touch', 'touch'],
  ['gyro', 'gyro'],
  ['sound', 'sound'],
  ['compass', 'compass'],
  ['irseeker', 'irseeker'],
  ['htcolour', 'colour'],
] as const

const field = (name: string, text: string) => `<field name="${name}">${text}</field>`
const value = (name: string, block: string) => `<value name="${name}">${block}</value>`
const block = (type: string, id: string, inside = '') =>
  `<block type="robBrick_${type}" id="${id}" intask="true">${inside}</block>`
const motor = (type: string, id: string, side: string, reverse = 'OFF') =>
  block(
    type,
    id,
    field('MOTOR_REGULATION', 'TRUE') +
      field('MOTOR_REVERSE', reverse) +
      (type === 'motor_big' ? field('MOTOR_DRIVE', side) : ''),
  )

function file(plugged: string): string {
  const brick = block(
    'EV3-Brick',
    'brick',
    field('WHEEL_DIAMETER', '4.3') +
      field('TRACK_WIDTH', '12.5') +
      plugged +
      value('MA', motor('motor_middle', 'm1', 'NONE', 'ON')) +
      value('MB', motor('motor_big', 'm2', 'LEFT')) +
      value('MC', motor('motor_big', 'm3', 'RIGHT')) +
      value('MD', block('actor', 'm4')),
  )
  const ns = 'http://de.fhg.iais.roberta.blockly'
  const set = (inside: string) =>
    `<block_set xmlns="${ns}" robottype="ev3" xmlversion="3.1" description="" tags="">${inside}</block_set>`
  const start = `<block type="robControls_start" id="start" intask="true"><mutation declare="false"></mutation>${field('DEBUG', 'FALSE')}</block>`
  return `<export xmlns="${ns}"><program>${set(`<instance x="1" y="2">${start}</instance>`)}</program><config>${set(`<instance x="213" y="213">${brick}</instance>`)}</config></export>`
}

it.each(sensors)(
  'a configuration with %s opens, is that robot, and is written back by name with its fields',
  (type, kind) => {
    const text = file(value('S1', block(type, 's1')) + value('S4', block(type, 's4')))
    const robot = robotIn(readOpenRoberta(text).config)
    expect([robot.sensors['1']?.kind, robot.sensors['4']?.kind]).toEqual([kind, kind])
    expect([robot.wheelDiameter, robot.trackWidth]).toEqual([4.3, 12.5])
    expect(robot.drive).toEqual({ left: 'B', right: 'C' })
    expect(xmlTree(fileFrom(projectFrom(text, 'x', garden), 'bo'))).toEqual(xmlTree(text))
  },
)

it('a block of a configuration that nobody knows stays in it', () => {
  const text = file(value('S2', block('nose', 's2', field('SMELL', 'a &amp; b'))))
  expect(robotIn(readOpenRoberta(text).config).sensors).toEqual({})
  expect(xmlTree(fileFrom(projectFrom(text, 'x', garden), 'bo'))).toEqual(xmlTree(text))
})

const withConfiguration = (inside: string) =>
  file('').replace(/(<config>.*?<instance[^>]*>).*(<\/instance>.*<\/config>)/, `$1${inside}$2`)

it('a brick that nobody knows keeps its configuration, also when the robot is built otherwise', () => {
  const brick = block('NXT-Brick', 'nxt', field('TRACK_WIDTH', '11') + value('S1', block('touch', 't')))
  const text = withConfiguration(brick)
  const project = projectFrom(text, 'x', garden)
  expect(xmlTree(fileFrom(project, 'bo'))).toEqual(xmlTree(text))
  const program = withRobot(readOpenRoberta(text), cardConfig)
  expect(program.config.stacks[0]).toEqual(readOpenRoberta(text).config.stacks[0])
  expect(robotIn(program.config)).toEqual(cardConfig)
})

it('a file without a configuration stays one while the robot is the one out of the box', () => {
  const text = file('').replace(/<config>.*<\/config>/, '')
  expect(xmlTree(fileFrom(projectFrom(text, 'x', garden), 'bo'))).toEqual(xmlTree(text))
})

const settings = {
  reversed: fc.constantFrom<true | undefined>(true, undefined),
  unregulated: fc.constantFrom<true | undefined>(true, undefined),
}
const motorOf = (...kinds: readonly MotorPlug['kind'][]): fc.Arbitrary<MotorPlug> =>
  fc.record({ kind: fc.constantFrom(...kinds), ...settings }).map(({ kind, reversed, unregulated }) => ({
    kind,
    ...(kind !== 'other' && reversed && { reversed }),
    ...(kind !== 'other' && unregulated && { unregulated }),
  }))
const place = { x: fc.integer({ min: -6, max: 10 }), y: fc.integer({ min: -6, max: 6 }) }
const sensor: fc.Arbitrary<SensorPlace> = fc
  .record({
    kind: fc.constantFrom('ultrasonic' as const, 'colour' as const, 'touch' as const, 'irseeker' as const),
    ...place,
    angle: fc.integer({ min: -175, max: 180 }),
    hitechnic: fc.boolean(),
  })
  .map(({ hitechnic, ...one }) =>
    one.kind === 'colour' && hitechnic ? { ...one, maker: 'hitechnic' as const } : one,
  )
/** Wheels are driven by large motors; at the other ports is anything, or nothing. */
const robots: fc.Arbitrary<RobotConfig> = fc
  .record({
    ports: fc.shuffledSubarray([...motorPorts], { minLength: 4 }),
    wheels: fc.tuple(motorOf('large'), motorOf('large')),
    others: fc.array(motorOf('large', 'medium', 'other'), { maxLength: 2 }),
    sensors: fc.dictionary(fc.constantFrom('1', '2', '3', '4'), sensor),
    wheelDiameter: fc.integer({ min: 30, max: 120 }).map((mm) => mm / 10),
    trackWidth: fc.integer({ min: 14, max: 26 }),
  })
  .map(({ ports, wheels, others, sensors, ...size }) => {
    const [left, right] = [ports[0]!, ports[1]!]
    const plugged = [...wheels, ...others].map((plug, k) => [ports[k]!, plug])
    return withMotors(
      { ...cardConfig, ...size, sensors: { ...sensors }, drive: { left, right } },
      Object.fromEntries(plugged) as NonNullable<RobotConfig['motors']>,
    )
  })

it('a robot of any build is in the file as it is, whatever robot the file had before', () => {
  const empty = { stacks: [], config: { stacks: [] } }
  fc.assert(
    fc.property(robots, robots, (before, after) => {
      const file = withRobot(withRobot(empty, before), after)
      expect(robotIn(file.config)).toEqual(after)
      expect(withRobot(file, after)).toBe(file)
    }),
    { seed: 11, numRuns: 300 },
  )
})
