import { content } from '@botgarten/content/files'
import type { Project } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { vi } from 'vitest'
import type { LoadedCard } from '#content/cards.ts'
import { friendship } from '#storage/testing/sample.ts'
import type { LabEvent } from '../change.ts'
import type { Opened } from '../opening.ts'
import { LabSession } from '../session.svelte.ts'

export const { card } = content.card('friendship')!

const open: LabSession[] = []

/** A session as the screen has it, on the card Friendship or in the free lab. */
export function sessionOf(
  project: Project = friendship,
  { isCard = true, ...more }: Partial<Opened> & { isCard?: boolean } = {},
) {
  const session = new LabSession({
    ...{ id: 'friendship', revision: 0, project, keeps: true, expert: false },
    card: isCard ? ({ card } as LoadedCard) : null,
    floor: paintFloor({ ...project.world, floor: { colour: '#FFFFFF' } }),
    ...{ floorAddress: null, error: null, damaged: null },
    ...more,
  })
  open.push(session)
  const events: LabEvent[] = []
  session.listen((event) => events.push(event))
  const kinds = () => events.map((one) => (one.kind === 'changed' ? one.change.kind : one.kind))
  return { session, kinds }
}

export function closeSessions(): void {
  for (const { autosave } of open.splice(0)) autosave.close()
}

/** Frames of a screen, which come when they are drawn. Returns how to draw one, so many milliseconds later. */
export function screen(): (milliseconds?: number) => void {
  const waiting = new Map<number, (now: number) => void>()
  let asked = 0
  let now = performance.now()
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => {
    waiting.set(++asked, frame)
    return asked
  })
  vi.stubGlobal('cancelAnimationFrame', (id: number) => waiting.delete(id))
  return (milliseconds = 100) => {
    const frames = [...waiting.values()]
    waiting.clear()
    now = Math.max(now, performance.now()) + milliseconds
    for (const frame of frames) frame(now)
  }
}
