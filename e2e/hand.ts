import type { CDPSession, Page } from '@playwright/test'

export interface Spot {
  readonly x: number
  readonly y: number
}

export type HandName = 'mouse' | 'finger'

/** The screen of a child that has only its fingers. */
export const tablet = { viewport: { width: 1024, height: 768 }, hasTouch: true }

/** What presses, moves and lets go: a mouse or a finger. */
export interface Hand {
  down(at: Spot): Promise<void>
  move(to: Spot): Promise<void>
  up(): Promise<void>
}

export function mouse(page: Page): Hand {
  return {
    down: async ({ x, y }) => {
      await page.mouse.move(x, y)
      await page.mouse.down()
    },
    move: ({ x, y }) => page.mouse.move(x, y),
    up: () => page.mouse.up(),
  }
}

/**
 * A finger that comes to rest before it leaves. One that leaves in full movement flings: Chromium takes the next tap, wherever
 * and however much later, for the one that stops the fling, and gives no click for it.
 */
const rests = (page: Page) =>
  page.evaluate(async () => {
    for (let frames = 6; frames > 0; frames -= 1) await new Promise(requestAnimationFrame)
  })

/** Playwright's own touch only taps; Chromium's drags. */
export function finger(page: Page): Hand {
  let session: Promise<CDPSession> | undefined
  const send = async (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: Spot[]) => {
    session ??= page.context().newCDPSession(page)
    await (await session).send('Input.dispatchTouchEvent', { type, touchPoints })
  }
  return {
    down: (at) => send('touchStart', [at]),
    move: (to) => send('touchMove', [to]),
    up: async () => {
      await rests(page)
      await send('touchEnd', [])
    },
  }
}

/** Two fingers on a line through a spot, at first so many px apart and in the end so many. */
export async function pinch(page: Page, { x, y }: Spot, from: number, to: number): Promise<void> {
  const session = await page.context().newCDPSession(page)
  const fingers = (apart: number) => [
    { x: x - apart / 2, y, id: 0 },
    { x: x + apart / 2, y, id: 1 },
  ]
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: Spot[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints })
  await send('touchStart', fingers(from))
  for (const share of [0.25, 0.5, 0.75, 1]) await send('touchMove', fingers(from + (to - from) * share))
  await rests(page)
  await send('touchEnd', [])
}
