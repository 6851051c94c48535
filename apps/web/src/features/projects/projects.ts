import type { Listed } from '#storage/projects.ts'
import type { Obstacle, World } from '@botgarten/simulation'

export type Order = 'time' | 'name'

/** From here on there is a field to search in. */
export const MANY = 8

const plain = (text: string) => text.normalize('NFKD').replace(/\p{M}/gu, '').toLocaleLowerCase()

/** What is called like the words, wherever they stand in its name, in the order asked for. */
export function findProjects(
  all: readonly Listed[],
  wanted: { readonly words: string; readonly order: Order; readonly locale: string },
  nameOf: (kept: Listed) => string,
): readonly Listed[] {
  const words = plain(wanted.words).split(/\s+/).filter(Boolean)
  const found = all.filter((one) => words.every((word) => plain(nameOf(one)).includes(word)))
  if (wanted.order === 'time') return found
  const { compare } = new Intl.Collator(wanted.locale, { numeric: true })
  return found.toSorted((a, b) => compare(nameOf(a), nameOf(b)))
}

/** The picture of a tile is so many times as wide as it is high. */
const wide = 2.6
/** Cm around Bo that are seen: it is drawn larger than it is. */
const around = 40

/** Which stripe of a world is seen, in cm from its top: Bo and, where it fits, what is next to it. */
export function stripeOf({ size, robots, obstacles }: World): {
  readonly top: number
  readonly height: number
} {
  const height = Math.min(size.height, size.width / wide)
  const bo = robots[0]?.pose ?? { x: size.width / 2, y: size.height / 2 }
  const away = ({ pose }: Obstacle) => Math.hypot(pose.x - bo.x, pose.y - bo.y)
  const next = obstacles.toSorted((a, b) => away(a) - away(b))[0]?.pose ?? bo
  const most = Math.max(0, height / 2 - around)
  const middle = size.height - bo.y + Math.min(most, Math.max(-most, (bo.y - next.y) / 2))
  return { top: Math.min(size.height - height, Math.max(0, middle - height / 2)), height }
}

/** The same as a part of the world. */
export const tilePart = (world: World) => ({ left: 0, width: world.size.width, ...stripeOf(world) })

/** What the menu of a project offers. */
export type Action =
  'rename' | 'duplicate' | 'share' | 'shareInClass' | 'saveFile' | 'saveOpenRoberta' | 'throw'
