import type { Command } from './commands.ts'
import { writeNumber } from '@botgarten/messages'
import type { Point } from './points.ts'

/** What has just been paid. */
export interface Coin {
  readonly text: string
  /** More than nothing. */
  readonly gains: boolean
}

/** What has just been paid, in tenths and with its sign; null where that is nothing. */
export function coinFor(paid: number, locale: string): Coin | null {
  if (Math.abs(paid) < 0.05) return null
  return { text: writeNumber(paid, locale, { least: 1, most: 1, plus: true }), gains: paid > 0 }
}

const radius = 22
/** From the middle of the robot, in px beside its body. */
const away = 20

/** How far from the middle of a robot its coin reaches, in px. */
export const coinReach = (bodyPx: number): number => (bodyPx + away) * 0.8 + radius + 2

/** A coin at the head of a robot, on the side it does not look to. `at`: px; `heading`: degrees counter-clockwise from the right. */
export function drawCoin(
  { text, gains }: Coin,
  at: Point,
  heading: number,
  bodyPx: number,
): readonly Command[] {
  const behind = Math.cos((heading * Math.PI) / 180) > 0 ? -1 : 1
  const far = bodyPx + away
  const [x, y] = [at.x + behind * far * 0.8, at.y - far * 0.8]
  const [fill, edge] = gains ? ['#FFC83D', '#C98F00'] : ['#F7D5CC', '#C9401F']
  return [
    { kind: 'circle', x, y, r: radius, fill, stroke: '#4A3428', lineWidth: 2.5 },
    { kind: 'circle', x, y, r: radius - 4.5, stroke: edge, lineWidth: 1.5 },
    { kind: 'text', x, y: y + 5.5, text, size: 15, font: 'title', align: 'middle', fill: '#3A2A20' },
  ]
}
