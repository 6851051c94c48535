import type { HelperAt, Helpers } from '../helpers.ts'
import { orders } from './devices.ts'
import { brick } from './pybricks.ts'

/** What stands on the hub's 5 × 5 lights: the same text does not go by again. */
const shown = ({ draft }: HelperAt) =>
  draft.device('shown', () => {
    const name = draft.names.of('device shown', 'shown')
    return { order: orders.timer - 1, name, code: [`${name} = [""]`] }
  })

/** What differs on a SPIKE Prime hub from Pybricks on an EV3. */
export const spike: Helpers = {
  show: (h) => {
    const [display, before] = [`${brick(h.draft)}.display`, shown(h)]
    return [
      '(text):',
      `if text == ${before}[0]:`,
      '    return',
      `${before}[0] = text`,
      'if len(text) == 1:',
      `    ${display}.char(text)`,
      'elif len(text) == 2 and text.isdigit():',
      `    ${display}.number(int(text))`,
      'else:',
      `    ${display}.text(text)`,
    ]
  },
  clear: (h) => ['():', `${shown(h)}[0] = ""`, `${brick(h.draft)}.display.off()`],
  rgb: () => [
    '(sensor):',
    'color = sensor.hsv()',
    'parts = []',
    'for start in (5, 3, 1):',
    '    place = (start + color.h / 60) % 6',
    '    grey = color.s / 100 * max(0, min(place, 4 - place, 1))',
    '    parts.append(color.v * (1 - grey) * 2.55)',
    'return parts',
  ],
}
