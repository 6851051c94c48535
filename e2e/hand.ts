import type { CDPSession, Page } from '@playwright/test'

export interface Spot {
  readonly x: number
  readonly y: number
}

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
    up: () => send('touchEnd', []),
  }
}
