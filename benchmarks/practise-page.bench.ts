import { brainsFor } from '@botgarten/lab'
import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content'
import { noExamples, withDrive } from '@botgarten/learning/neural-network/examples'
import { draw, stream } from '@botgarten/numbers'
import { withHidden } from '@botgarten/programs/examples'
import type { Page } from '@playwright/test'
import { launchBrowser } from '../e2e/browser.ts'
import { Child } from '../e2e/child.ts'
import { buildWhenNeeded } from '../scripts/prepare/build.mjs'
import { startServer } from '../scripts/server.ts'
import { median, ms, type Table } from './bench.ts'
import { frameCells, framesDuring, freshPage, rounds, throttle, throttled } from './slow.ts'

const examples = 600

/** Friendship with four hidden tanh neurons and 600 rows, each with its mirror image when it practises. */
function project() {
  const { world, card } = content.card('friendship')!
  const own = cardProject(world, card, content.program('friendship', 'start')!, 'friendship')
  const main = withHidden(own.programs['main']!, 'net', [{ neurons: 4, activation: 'tanh' }])
  const programs = { ...own.programs, main }
  const brains = brainsFor(programs, own.brains)
  const dice = stream(23, 'bench')
  const percent = () => Math.round(100 * draw(dice))
  const rows = Array.from({ length: examples }, (_, k) => ({
    ...{ tick: 6 * k, pose: { x: 100, y: 100, heading: 0 } },
    ...{ inputs: [percent(), percent()], outputs: [percent(), percent()] },
  }))
  const none = noExamples(['eyeLeft', 'eyeRight'], ['wheelLeft', 'wheelRight'])
  const shown = withDrive(none, { id: 'pad-1', by: 'pad', seed: 1 }, rows).examples
  return { ...own, programs, brains: { ...brains, net: { ...brains['net']!, examples: shown } } }
}

/** Presses the main button. Milliseconds until the first round has passed, and until the button says this again. */
const timed = (page: Page) =>
  page.evaluate(async () => {
    const button = document.querySelector<HTMLElement>('.practise .bar .button.network')!
    const round = () => Number(document.querySelector('.curve [role=slider]')!.getAttribute('aria-valuenow'))
    const from = round()
    const began = performance.now()
    button.click()
    let first = 0
    do {
      await new Promise((next) => requestAnimationFrame(next))
      if (first === 0 && round() !== from) first = performance.now() - began
    } while (first === 0 || button.textContent.includes('Pause'))
    return { first, all: performance.now() - began }
  })

/** Milliseconds from a press on Pause until the button says so, and until the last whole round is shown and can be dragged. */
const paused = (page: Page) =>
  page.evaluate(async () => {
    const button = document.querySelector<HTMLElement>('.practise .bar .button.network')!
    button.click()
    await new Promise((next) => setTimeout(next, 400))
    const began = performance.now()
    button.click()
    const slider = document.querySelector('.curve [role=slider]')!
    const until = async (reached: () => boolean) => {
      while (!reached()) await new Promise((next) => setTimeout(next, 1))
      return performance.now() - began
    }
    const said = await until(() => !button.textContent.includes('Pause'))
    return { said, rests: await until(() => slider.ariaDisabled !== 'true') }
  })

async function opened(page: Page): Promise<Child> {
  const child = new Child(page, 'en')
  await child.opensHome()
  await child.opensFileAtHome('bench.botgarten.json', JSON.stringify(project()))
  await child.seesLab()
  await child.presses('network.letPractise')
  await page.locator('.practise .bar').waitFor()
  return child
}

/** Practice on the page of a slow laptop: how long rounds take, how soon it pauses, how smoothly all of it moves. */
export default async function practisePage(): Promise<Table> {
  await buildWhenNeeded()
  const server = await startServer({ port: 0, host: '127.0.0.1' })
  const browser = await launchBrowser()
  try {
    const [firsts, alls, pauses, rests, frames] = [[], [], [], [], []] as [
      number[],
      number[],
      number[],
      number[],
      Awaited<ReturnType<typeof framesDuring>>[],
    ]
    for (let k = 0; k < rounds; k++) {
      const page = await throttled(await freshPage(browser, server.url))
      const child = await opened(page)
      const { first, all } = await timed(page)
      firsts.push(first)
      alls.push(all)
      await page.locator('.settings select').nth(1).selectOption({ label: '1000' })
      const pause = await paused(page)
      pauses.push(pause.said)
      rests.push(pause.rests)
      await page.locator('.settings select').nth(2).selectOption({ index: 2 })
      await child.presses('training.fieldView')
      await child.pressesStart()
      frames.push(
        await framesDuring(page, async () => {
          await page.locator('.practise .bar .button.network').click()
          await page.waitForFunction(
            (end) => performance.now() > end,
            await page.evaluate(() => performance.now() + 4000),
          )
        }),
      )
      await page.context().close()
    }
    const figures = (values: readonly number[]) => [ms(median(values)), ms(Math.max(...values))]
    return {
      title: 'Practice on the page',
      how: `Friendship with 2-4-2 tanh, ${examples} rows and their mirror images, 60 rounds as fast as it can; the processor at a ${throttle}th, ${rounds} fresh pages.`,
      columns: ['what', 'middle', 'worst'],
      rows: [
        ['first change after the tap', ...figures(firsts)],
        ['60 rounds, all drawn', ...figures(alls)],
        ['pause after the tap: it says so', ...figures(pauses)],
        ['pause after the tap: the last whole round is shown', ...figures(rests)],
        ['60 rounds a second, field, curve and Bo moving', frameCells(frames).join(' · '), ''],
      ],
    }
  } finally {
    await browser.close()
    await server.close()
  }
}
