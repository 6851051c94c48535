import type { HelperAt, Helpers } from '../helpers.ts'
import { colourNames, shownAs } from './colours.ts'
import { leds, screen, sound, tank } from './ev3dev2.ts'

const config = ({ draft }: HelperAt) => draft.input.config

/** Degrees of a wheel for so many cm. */
const turnsFor = (h: HelperAt) => `cm / (${h.math('pi')} * ${config(h).wheelDiameter}) * 360`

/** What the blocks mean, for python-ev3dev2. */
export const ev3dev2: Helpers = {
  cut: () => ['(percent):', 'return max(-100, min(100, percent))'],
  speed: (h) => [
    '(percent):',
    `return ${h.draft.import('ev3dev2.motor', 'SpeedDPS')}(${h.call('cut')}(percent) * 7.2)`,
  ],
  drive: (h) => {
    const speed = h.call('speed')
    return ['(left, right):', `${tank(h.draft)}.on(${speed}(left), ${speed}(right))`]
  },
  forward: ({ call }) => ['(percent):', `${call('drive')}(percent, percent)`],
  spin: ({ call }) => ['(percent):', `${call('drive')}(percent, -percent)`],
  straight: (h) => {
    const speed = h.call('speed')
    return [
      '(percent, cm):',
      'if percent * cm == 0:',
      `    ${tank(h.draft)}.off()`,
      '    return',
      `degrees = ${turnsFor(h)}`,
      `${tank(h.draft)}.on_for_degrees(${speed}(percent), ${speed}(percent), degrees)`,
    ]
  },
  turn: (h) => {
    const speed = h.call('speed')
    return [
      '(percent, angle):',
      'if percent * angle == 0:',
      `    ${tank(h.draft)}.off()`,
      '    return',
      `degrees = angle * ${config(h).trackWidth} / ${config(h).wheelDiameter}`,
      `${tank(h.draft)}.on_for_degrees(${speed}(percent), ${speed}(-percent), degrees)`,
    ]
  },
  curve: (h) => {
    const [cut, speed] = [h.call('cut'), h.call('speed')]
    return [
      '(left, right, cm):',
      `left, right = ${cut}(left), ${cut}(right)`,
      'middle = abs(left + right) / 2 or abs(left)',
      'if middle * cm == 0:',
      `    ${tank(h.draft)}.off()`,
      '    return',
      'faster = max(abs(left), abs(right))',
      `degrees = ${turnsFor(h)} * faster / middle`,
      `${tank(h.draft)}.on_for_degrees(${speed}(left), ${speed}(right), degrees)`,
    ]
  },
  show: (h) => {
    const name = screen(h.draft)
    return [
      '(text, column, row):',
      `x = 10 * max(0, min(16, ${h.math('floor')}(column + 0.5)))`,
      `y = 16 * max(0, min(7, ${h.math('floor')}(row + 0.5)))`,
      'right = x + 10 * len(text)',
      `${name}.rectangle(False, x, y, right, y + 15, "white", "white")`,
      `${name}.text_pixels(text, False, x, y)`,
      `${name}.update()`,
    ]
  },
  clear: (h) => ['():', `${screen(h.draft)}.clear()`, `${screen(h.draft)}.update()`],
  color_name: (h) => {
    const color = h.draft.import('ev3dev2.sensor.lego', 'ColorSensor')
    return [
      '(color):',
      'names = {',
      ...shownAs.map(([value, name]) => `    ${color}.${colourNames(value).ev3dev2}: "${name}",`),
      '}',
      'return names.get(color, "")',
    ]
  },
  distance: () => ['(eye):', 'return min(eye.distance_centimeters, 100)'],
  sees: () => ['(sensor, color):', 'return 100 if sensor.color == color else 0'],
  lamp: (h) => {
    const name = leds(h.draft)
    return [
      '(color):',
      `${name}.animate_stop()`,
      'if color is None:',
      `    ${name}.all_off()`,
      'else:',
      `    ${name}.set_color("LEFT", color)`,
      `    ${name}.set_color("RIGHT", color)`,
    ]
  },
  tone: (h) => [
    '(hertz, milliseconds):',
    'if hertz > 0 and milliseconds > 0:',
    `    ${sound(h.draft)}.play_tone(hertz, milliseconds / 1000)`,
    'elif milliseconds > 0:',
    `    ${h.at.robot.wait('milliseconds')}`,
  ],
  hum: (h) => {
    const kind = h.draft.import('ev3dev2.sound', 'Sound')
    return [
      '(level):',
      'if level > 0:',
      `    ${sound(h.draft)}.play_tone(level * 5, 0.1, play_type=${kind}.PLAY_NO_WAIT_FOR_COMPLETE)`,
    ]
  },
  say: (h) => [
    '(text, speed, pitch):',
    'options = "-a 200 -s {} -p {}".format(int(80 + 2 * speed), int(pitch))',
    `${sound(h.draft)}.speak(text, options)`,
  ],
}
