import { expect } from '@playwright/test'
import type { Child } from './child.ts'
import type { serverWithData } from './class-server.ts'

type EmptyServer = Awaited<ReturnType<typeof serverWithData>>

/** A picture of a server that waits for its first teacher. */
export interface StartScreen {
  readonly name: string
  show(child: Child, server: EmptyServer): Promise<void>
}

/** Goes so many steps of the first start. */
async function starts(child: Child, server: EmptyServer, steps: number) {
  const { page } = child
  await page.goto(`/teacher/start#${await server.classServer.firstTeacher()}`)
  await page.getByLabel(child.word('teacher.username'), { exact: true }).fill('m.weber')
  await page.getByLabel(child.word('teacher.password'), { exact: true }).fill('kastanie im regen')
  if (steps > 0) await child.presses('teacher.makeAccount')
  if (steps > 0) await page.getByLabel(child.word('teacher.className'), { exact: true }).fill('5b')
  if (steps > 1) await child.presses('teacher.makeClass')
  if (steps > 1) await page.getByLabel(child.word('teacher.wifiName'), { exact: true }).fill('Botgarten')
  if (steps > 2) await child.presses('teacher.wifiShow')
  if (steps > 2) await expect(child.button('teacher.rehearseNow')).toBeVisible()
  if (steps > 3) await child.presses('teacher.rehearseSkip')
  if (steps > 4) await child.presses('teacher.backUpNow')
  if (steps > 4) await expect(child.button('teacher.phrase.written')).toBeVisible()
  if (steps > 5) await child.presses('teacher.phrase.written')
  if (steps > 5) await expect(page.getByRole('link', { name: child.word('teacher.toClass') })).toBeVisible()
}

const steps = ['account', 'class', 'wifi', 'rehearse', 'backup', 'phrase', 'done']

/** A rehearsal as the server tells of it. */
async function rehearses(child: Child, server: EmptyServer, events: readonly object[], isOver: boolean) {
  const body = events.map((one) => `event: progress\ndata: ${JSON.stringify(one)}\n\n`).join('')
  await starts(child, server, 3)
  await child.page.evaluate(
    ([body, isOver]) => {
      const own = globalThis.fetch
      globalThis.fetch = (address, init) => {
        if (address !== '/api/class/rehearsal') return own(address, init)
        const stream = new ReadableStream({
          start(controller) {
            controller.enqueue(new TextEncoder().encode(body))
            if (isOver) controller.close()
          },
        })
        return Promise.resolve(new Response(stream))
      }
    },
    [isOver ? body.replaceAll('progress', 'done') : body, isOver] as const,
  )
  await child.presses('teacher.rehearseNow')
}

export const startScreens: readonly StartScreen[] = [
  ...steps.map((name, at) => ({
    name: `first-start-${name}`,
    show: (child: Child, server: EmptyServer) => starts(child, server, at),
  })),
  {
    name: 'first-start',
    async show(child, server) {
      const progress = { pupils: 35, joined: 35, saves: 280, slowest: 40, seconds: 42, of: 60 }
      await rehearses(child, server, [progress], false)
      await expect(child.page.getByText('280')).toBeVisible()
    },
  },
  {
    name: 'first-start-red',
    async show(child, server) {
      const outcome = { green: false, pupils: 35, saves: 412, lost: 0, p99: 2140, slowest: 3100, rss: 180 }
      await rehearses(child, server, [outcome], true)
      await expect(child.button('teacher.rehearseAgain')).toBeVisible()
    },
  },
  {
    name: 'first-start-no-link',
    async show(child) {
      await child.page.goto('/teacher')
      await child.seesTitle()
    },
  },
]
