import { colours, nothing } from '@botgarten/blocks'
import type { PortSense, RobotView, Senses } from '@botgarten/lab'
import { writeNumber } from '@botgarten/messages'
import type { Uses } from '@botgarten/programs'
import type { LedColour, RobotConfig, SensorKind } from '@botgarten/simulation'
import type { Badge } from '#drawing/badges.ts'
import { lamps } from '#drawing/bo.ts'
import { language } from '#words/language.svelte.ts'
import { message, m } from '#words/message.ts'

/** Of the floor where no sensor sees a colour. */
const blank = '#FFFDF8'
/** Rows of a display that stand beside Bo; the drawer of its panel shows all of them. */
const most = 3
/** Letters of what Bo says that stand beside it. */
const longest = 28

const lampNames: { readonly [colour in LedColour]: () => string } = {
  green: m['choice.green'],
  orange: m['world.badge.orange'],
  red: m['choice.red'],
}

type Said = Pick<Badge, 'icon' | 'label' | 'value' | 'idle'>
type Say = (sense: PortSense, uses: Uses) => readonly Said[]

/** What the badges of a sensor say; what distance sensors see is drawn on the floor. */
const senseBadges: { readonly [kind in SensorKind]?: Say } = {
  colour: (sense, uses) => [
    ...(uses.colour.includes(sense.port) ? seen(sense) : []),
    ...(uses.light.includes(sense.port) ? bright(sense) : []),
  ],
  touch: ({ values }) => [touched(values.touch === 1)],
  gyro: ({ values }) => degrees('turn', m['world.badge.turned'](), values.angle),
  compass: ({ values }) => degrees('compass', m['world.badge.compass'](), values.compass),
  sound: ({ values }) => heard(values.sound),
}

/** Does a program use a sensor that has a badge? */
export const sensesShown = ({ ports }: Uses, { sensors }: RobotConfig): boolean =>
  ports.some((port) => sensors[port] && senseBadges[sensors[port].kind])

/** What a robot senses and does, as far as its program has to do with it. `senses`: null where none is to be shown. */
export const badgesOf = (robot: RobotView, uses: Uses, senses: Senses | null): readonly Badge[] => [
  ...(senses?.ports.filter(({ port }) => uses.ports.includes(port)).flatMap((one) => sensed(one, uses)) ??
    []),
  ...(uses.lamp || robot.led ? [lamp(robot)] : []),
  ...(uses.display || robot.display.some(Boolean) ? [display(robot)] : []),
  ...(uses.sound || robot.frequency !== null ? [tone(robot)] : []),
  ...(uses.speech || robot.speech !== null ? [speech(robot)] : []),
]

const sensed = (sense: PortSense, uses: Uses): readonly Badge[] =>
  (senseBadges[sense.kind]?.(sense, uses) ?? []).map((said, index) => ({
    ...{ id: `${sense.kind} ${sense.port} ${index}`, side: 'sensor', part: `sensor ${sense.port}` },
    ...said,
  }))

function seen({ values }: PortSense): readonly Said[] {
  if (values.colour === undefined) return []
  const colour = colours.find((one) => one.value === values.colour)
  const value = colour ? message(`choice.${colour.words}`) : m['world.badge.nothing']()
  return [
    {
      icon: { colour: colour?.value ?? blank },
      label: m['world.badge.sees'](),
      value: [value],
      idle: !colour,
    },
  ]
}

const rounded = (value: unknown): readonly number[] =>
  typeof value === 'number' ? [Math.round(value) + 0] : []

const bright = ({ values }: PortSense): readonly Said[] =>
  rounded(values.light).map((light) => ({
    ...{ icon: 'light', label: m['world.badge.light'](), value: [String(light)], idle: false },
  }))

const touched = (pressed: boolean): Said => ({
  ...{ icon: 'bumper', label: m['world.badge.bumper'](), idle: !pressed },
  value: [pressed ? m['world.badge.pressed']() : m['world.badge.free']()],
})

const degrees = (icon: 'turn' | 'compass', label: string, angle: unknown): readonly Said[] =>
  rounded(angle).map((value) => ({
    icon,
    label,
    value: [`${writeNumber(value, language.locale)}°`],
    idle: false,
  }))

const heard = (level: unknown): readonly Said[] =>
  rounded(level).map((loud) => ({
    ...{ icon: 'ear', label: m['world.badge.hears'](), value: [String(loud)], idle: loud === 0 },
  }))

const lamp = ({ led }: RobotView): Badge => ({
  ...{ id: 'lamp', side: 'output', part: 'lamp', idle: led === null },
  icon: { colour: led ? lamps[led] : blank },
  label: m['world.badge.lamp'](),
  value: [led ? lampNames[led]() : m['world.badge.off']()],
})

/** A word in quotation marks; that there is none stands without them. */
const wordIn = (row: string) =>
  row === nothing ? m['neuron.empty']() : m['world.badge.word']({ text: row.trim() })

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

const shortened = (text: string) =>
  [...text].length > longest ? `${[...text].slice(0, longest).join('')}…` : text

const speech = ({ speech }: RobotView): Badge => ({
  ...{ id: 'speech', side: 'output', part: 'display', icon: 'speech', idle: !speech },
  label: m['world.badge.says'](),
  value: [speech ? wordIn(shortened(speech)) : m['world.badge.nothing']()],
})
