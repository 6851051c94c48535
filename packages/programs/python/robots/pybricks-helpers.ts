import type { HelperAt, Helpers } from '../helpers.ts'
import { colourNames, shownAs } from './colours.ts'
import { base, brick, mm, motor } from './pybricks.ts'

const wheels = ({ draft }: HelperAt) => {
  const { left, right } = draft.input.config.drive
  return [motor(draft, left), motor(draft, right)] as const
}
const config = ({ draft }: HelperAt) => draft.input.config
const parameter = ({ draft }: HelperAt, name: string) => draft.import('pybricks.parameters', name)

/** What the blocks mean, for Pybricks 4 on an EV3. */
export const pybricks: Helpers = {
  cut: () => ['(percent):', 'return max(-100, min(100, percent))'],
  speed: ({ call }) => ['(percent):', `return ${call('cut')}(percent) * 7.2`],
  drive: (h) => {
    const [left, right] = wheels(h)
    const speed = h.call('speed')
    return ['(left, right):', `${left}.run(${speed}(left))`, `${right}.run(${speed}(right))`]
  },
  forward: ({ call }) => ['(percent):', `${call('drive')}(percent, percent)`],
  spin: ({ call }) => ['(percent):', `${call('drive')}(percent, -percent)`],
  stop: (h) => ['():', ...wheels(h).map((name) => `${name}.brake()`)],
  straight: (h) => {
    const robot = base(h.draft)
    const perDegree = `${h.math('pi')} * ${mm(config(h).wheelDiameter)} / 360`
    return [
      '(percent, cm):',
      'if percent * cm == 0:',
      `    ${h.call('stop')}()`,
      '    return',
      `${robot}.settings(straight_speed=abs(${h.call('speed')}(percent)) * ${perDegree})`,
      `${robot}.straight(cm * 10 if percent > 0 else -cm * 10)`,
    ]
  },
  turn: (h) => {
    const robot = base(h.draft)
    const { wheelDiameter, trackWidth } = config(h)
    const perDegree = `${mm(wheelDiameter)} / ${mm(trackWidth)}`
    return [
      '(percent, degrees):',
      'if percent * degrees == 0:',
      `    ${h.call('stop')}()`,
      '    return',
      `${robot}.settings(turn_rate=abs(${h.call('speed')}(percent)) * ${perDegree})`,
      `${robot}.turn(degrees if percent > 0 else -degrees)`,
    ]
  },
  curve: (h) => {
    const [left, right] = wheels(h)
    const [cut, speed] = [h.call('cut'), h.call('speed')]
    return [
      '(left, right, cm):',
      `left, right = ${cut}(left), ${cut}(right)`,
      'middle = abs(left + right) / 2 or abs(left)',
      'if middle * cm == 0:',
      `    ${h.call('stop')}()`,
      '    return',
      `degrees = cm / (${h.math('pi')} * ${config(h).wheelDiameter}) * 360 / middle`,
      'if left:',
      `    ${left}.run_angle(${speed}(left), abs(left) * degrees, wait=False)`,
      'if right:',
      `    ${right}.run_angle(${speed}(right), abs(right) * degrees, wait=False)`,
      `while not (${left}.done() and ${right}.done()):`,
      `    ${h.at.robot.wait('10')}`,
    ]
  },
  show: (h) => [
    '(text, column, row):',
    `x = 10 * max(0, min(16, ${h.math('floor')}(column + 0.5)))`,
    `y = 16 * max(0, min(7, ${h.math('floor')}(row + 0.5)))`,
    `${brick(h.draft)}.screen.draw_text(x, y, text, background_color=${parameter(h, 'Color')}.WHITE)`,
  ],
  color_name: (h) => {
    const color = parameter(h, 'Color')
    return [
      '(color):',
      'names = [',
      ...shownAs.map(([value, name]) => `    (${color}.${colourNames(value).pybricks}, "${name}"),`),
      ']',
      'for one, name in names:',
      '    if one == color:',
      '        return name',
      'return ""',
    ]
  },
  distance: () => ['(eye):', 'return min(eye.distance() / 10, 100)'],
  sees: () => ['(sensor, color):', 'return 100 if sensor.color() == color else 0'],
  rgb: () => ['(sensor):', 'return [part * 2.55 for part in sensor.rgb()]'],
  lamp: (h) => {
    const light = `${brick(h.draft)}.light`
    return ['(color):', 'if color is None:', `    ${light}.off()`, 'else:', `    ${light}.on(color)`]
  },
  tone: (h) => [
    '(hertz, milliseconds):',
    'if hertz > 0 and milliseconds > 0:',
    `    ${brick(h.draft)}.speaker.beep(hertz, milliseconds)`,
    'elif milliseconds > 0:',
    `    ${h.at.robot.wait('milliseconds')}`,
  ],
  hum: (h) => {
    const beep = `${brick(h.draft)}.speaker.beep`
    return ['(level):', 'if level > 0:', `    ${beep}(level * 5, -1)`, 'else:', `    ${beep}(100, 0)`]
  },
}
