import { colours, nothing } from '@botgarten/blocks'
import type { RobotView, Senses } from '@botgarten/lab'
import type { Uses } from '@botgarten/programs'
import type { LedColour, SensorPort } from '@botgarten/simulation'
import type { Badge } from '#drawing/badges.ts'
import { lamps } from '#drawing/bo.ts'
import { message, m } from '#words/message.ts'

/** Of the floor where no sensor sees a colour. */
const blank = '#FFFDF8'
/** Rows of a display that stand beside Bo; the drawer of its panel shows all of them. */
const most = 3

const lampNames: { readonly [colour in LedColour]: () => string } = {
  green: m['choice.green'],
  orange: m['world.badge.orange'],
  red: m['choice.red'],
}

/** What a robot senses and does, as far as its program has to do with it. `senses`: null where none is to be shown. */
export const badgesOf = (robot: RobotView, uses: Uses, senses: Senses | null): readonly Badge[] => [
  ...(senses ? uses.colour.flatMap((port) => seen(port, senses)) : []),
  ...(senses ? uses.light.flatMap((port) => bright(port, senses)) : []),
  ...(uses.lamp || robot.led ? [lamp(robot)] : []),
  ...(uses.display || robot.display.some(Boolean) ? [display(robot)] : []),
  ...(uses.sound || robot.frequency !== null ? [tone(robot)] : []),
]

const valuesAt = (port: SensorPort, { ports }: Senses) => ports.find((one) => one.port === port)?.values

function seen(port: SensorPort, senses: Senses): readonly Badge[] {
  const value = valuesAt(port, senses)?.colour
  if (value === undefined) return []
  const colour = colours.find((one) => one.value === value)
  return [
    {
      ...{ id: `colour ${port}`, side: 'sensor', part: `sensor ${port}`, idle: !colour },
      icon: { colour: colour?.value ?? blank },
      label: m['world.badge.sees'](),
      value: [colour ? message(`choice.${colour.words}`) : m['world.badge.nothing']()],
    },
  ]
}

function bright(port: SensorPort, senses: Senses): readonly Badge[] {
  const value = valuesAt(port, senses)?.light
  if (typeof value !== 'number') return []
  return [
    {
      ...{ id: `light ${port}`, side: 'sensor', part: `sensor ${port}`, idle: false, icon: 'light' },
      label: m['world.badge.light'](),
      value: [String(Math.round(value))],
    },
  ]
}

const lamp = ({ led }: RobotView): Badge => ({
  ...{ id: 'lamp', side: 'output', part: 'lamp', idle: led === null },
  icon: { colour: led ? lamps[led] : blank },
  label: m['world.badge.lamp'](),
  value: [led ? lampNames[led]() : m['world.badge.off']()],
})

const wordIn = (row: string) =>
  m['world.badge.word']({ text: row === nothing ? m['neuron.empty']() : row.trim() })

function display({ display }: RobotView): Badge {
  const rows = display.filter((row) => row.trim() !== '')
  return {
    ...{ id: 'display', side: 'output', part: 'display', icon: 'display', idle: rows.length === 0 },
    label: m['world.badge.shows'](),
    value: rows.length === 0 ? [m['world.badge.nothing']()] : rows.slice(0, most).map(wordIn),
  }
}

const tone = ({ frequency }: RobotView): Badge => ({
  ...{ id: 'tone', side: 'output', part: 'lamp', icon: 'sound', idle: !frequency },
  label: m['world.badge.tone'](),
  value: [frequency ? m['world.badge.hertz']({ hertz: Math.round(frequency) }) : m['world.badge.silent']()],
})
