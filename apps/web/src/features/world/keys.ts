import type { DriveKey } from '@botgarten/lab'
import type { Pose } from '@botgarten/simulation'
import { fullTurn } from '#drawing/things.ts'

const drive: { readonly [key: string]: DriveKey } = {
  ArrowUp: 'up',
  ArrowDown: 'down',
  ArrowLeft: 'left',
  ArrowRight: 'right',
}

const shift: { readonly [key: string]: readonly [number, number] } = {
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
}

const turn: { readonly [key: string]: number } = { ',': 5, '[': 5, '.': -5, ']': -5 }

type KeyPress = Pick<KeyboardEvent, 'key'> &
  Partial<Pick<KeyboardEvent, 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>>

const withCommand = ({ ctrlKey, metaKey, altKey }: KeyPress) =>
  ctrlKey === true || metaKey === true || altKey === true

/** The arrow that drives, or null. */
export const driveKey = (press: KeyPress): DriveKey | null =>
  withCommand(press) ? null : (drive[press.key] ?? null)

/** Comma and dot (or brackets) turn by 5°; null for other keys. */
export function turnedBy(press: KeyPress, pose: Pose): Pose | null {
  const by = turn[press.key]
  return by === undefined || withCommand(press) ? null : { ...pose, heading: fullTurn(pose.heading + by) }
}

/** Arrows move a thing by 1 cm, with Shift by 10; null for other keys. */
export function movedBy(press: KeyPress, pose: Pose): Pose | null {
  const by = shift[press.key]
  if (!by || withCommand(press)) return null
  const far = press.shiftKey ? 10 : 1
  return { ...pose, x: pose.x + by[0] * far, y: pose.y + by[1] * far }
}

/** Plus and minus bring the floor nearer and farther, 0 brings all of it into sight; null for other keys. */
export function zoomKey(press: KeyPress): 'nearer' | 'farther' | 'all' | null {
  if (withCommand(press)) return null
  if (press.key === '+' || press.key === '=') return 'nearer'
  if (press.key === '-') return 'farther'
  return press.key === '0' ? 'all' : null
}
