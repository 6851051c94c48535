import { colours } from '@botgarten/blocks'
import type { PortSense, Senses } from '@botgarten/lab'
import type { Colour, ReadMode, RobotConfig } from '@botgarten/simulation'
import { formatNumber } from '#drawing/numbers.ts'
import { message } from '#words/message.ts'

/** A line of the table: what it is, what it says, and the colour that is seen where it says one. */
export interface SenseRow {
  readonly id: string
  readonly place: string
  readonly label: string
  readonly value: string
  readonly colour?: Colour
}

/** Digits behind the comma, and the unit. */
const units: { readonly [mode in ReadMode]?: readonly [digits: number, unit: string] } = {
  distance: [0, ' cm'],
  light: [0, ' %'],
  angle: [0, '°'],
  rate: [0, '°/s'],
  compass: [0, '°'],
  x: [1, ' cm'],
  y: [1, ' cm'],
  heading: [0, '°'],
}

/** The table of a robot's senses in the child's words and numbers. */
export const rowsOf = (senses: Senses, { drive }: RobotConfig, locale: string): SenseRow[] => [
  ...senses.ports.flatMap((sense) => portRows(sense, locale)),
  ...senses.motors
    .filter(
      ({ port, turned, percent }) => port === drive.left || port === drive.right || turned + percent !== 0,
    )
    .map(({ port, percent, turned }) => ({
      id: `motor ${port}`,
      place: port,
      label: message('robot.motor'),
      value: `${formatNumber(percent, locale, 0)} %, ${formatNumber(turned, locale, 0)}°`,
    })),
  ...senses.timers.map((milliseconds, index) => ({
    id: `timer ${index}`,
    place: String(index + 1),
    label: message('robot.timer'),
    value: `${formatNumber(milliseconds, locale, 0)} ms`,
  })),
]

type Reading = number | Colour | null

const portRows = (
  { port, values: { red, green, blue, ...values } }: PortSense,
  locale: string,
): SenseRow[] => [
  ...(Object.entries(values) as [ReadMode, Reading][]).map(([mode, value]) => ({
    id: `${port} ${mode}`,
    place: port,
    label: message(`robot.mode.${mode}`),
    value: valueOf(mode, value, locale),
    ...(mode === 'colour' && value !== '' ? { colour: String(value) } : {}),
  })),
  ...(red === undefined ? [] : [channelsRow(port, [red, green, blue], locale)]),
]

const channelsRow = (port: string, channels: readonly (Reading | undefined)[], locale: string): SenseRow => ({
  id: `${port} channels`,
  place: port,
  label: message('robot.mode.channels'),
  value: channels.map((channel) => formatNumber(Number(channel), locale, 0)).join(' · '),
})

function valueOf(mode: ReadMode, value: Reading, locale: string): string {
  if (mode === 'touch') return message(value === 1 ? 'robot.pressed' : 'robot.free')
  if (mode === 'colour') {
    const colour = colours.find((one) => one.value === value)
    return colour ? message(`choice.${colour.words}`) : '–'
  }
  if (typeof value !== 'number') return '–'
  const [digits, unit] = units[mode] ?? [0, '']
  return formatNumber(value, locale, digits) + unit
}
