import { content } from '@botgarten/content/files'
import type { Child } from '../child.ts'
import { expect, follows, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

const textOf = (id: string) => content.cages.find(({ cage }) => cage.id === id)!.text['en']!
const senseTextOf = (id: string) => content.senseCages.find(({ cage }) => cage.id === id)!.text['en']!

const enters = (title: string) => (child: Child) => child.page.getByRole('link', { name: title }).click()
const guesses = (guess: string) => (child: Child) =>
  child.page.getByRole('button', { name: guess, exact: true }).click()
const pays = ({ page }: Child, id: string) => page.getByRole('slider', { name: textOf(id).mend })
const goesBack = async (child: Child) => {
  await child.page.clock.resume()
  await child.page.getByRole('link', { name: child.word('zoo.back'), exact: true }).click()
}
/** From now on time passes by `waits` alone, so that a moving scene can be compared. */
async function stopsTime({ page }: Child, minutes = 1) {
  if (minutes === 1) await page.clock.install()
  await page.clock.pauseAt(Date.now() + minutes * 60_000)
}
const waits = ({ page }: Child, ms: number) => page.clock.runFor(ms)
const allMoves = 120_000

const fountain = textOf('fountain')
const maps: Steps = {
  'all cages': (child) => follows(child, 'home.zoo'),
  'the fountain': enters(fountain.title),
  'a hint': (child) => child.presses('lab.hint'),
  'the next hint': (child) => child.presses('lab.hintNext'),
  'the hint before': (child) => child.presses('lab.hintBefore'),
  'hints are closed': (child) => child.presses('parts.close'),
  'hints are opened and closed by one button': async (child) => {
    await child.presses('lab.hint')
    await child.presses('lab.hint')
    await guesses(fountain.guess.wish)(child)
  },
  'another guess': guesses(fountain.guess.never),
  'Bo is on its second move': async (child) => {
    await guesses(fountain.guess.wish)(child)
    await stopsTime(child)
    await child.presses('zoo.learn')
    await waits(child, 900)
  },
  'it is held': (child) => child.presses('zoo.pause'),
  'it goes on': (child) => child.presses('zoo.goOn'),
  'Escape holds it': (child) => child.types('Escape'),
  'one move': async (child) => {
    await child.presses('zoo.oneMove')
    await waits(child, 700)
  },
  'from the beginning': async (child) => {
    await child.presses('zoo.again')
    await waits(child, 700)
    await child.types('Escape')
  },
  'all moves': async (child) => {
    await child.presses('zoo.goOn')
    await waits(child, allMoves)
  },
  'less pay': async (child) => {
    await pays(child, 'fountain').focus()
    await child.types('ArrowLeft')
  },
  'the right pay': (child) => child.types('ArrowLeft', 'ArrowLeft'),
  'Bo does what is meant': async (child) => {
    await child.presses('zoo.learn')
    await waits(child, allMoves)
  },
  'the next cage': async (child) => {
    await child.page.clock.resume()
    await child.page.getByRole('link', { name: child.word('zoo.next') }).click()
    await expect(child.page.getByText(textOf('puddle').wish, { exact: true })).toBeVisible()
  },
  'one cage is fixed': goesBack,
  'a cage with a few ways to pay': enters(textOf('hill').title),
  'its ways': async (child) => {
    await guesses(textOf('hill').guess.other)(child)
    await stopsTime(child, 10)
    await child.presses('zoo.learn')
    await waits(child, allMoves)
  },
  'another way': (child) => child.page.getByRole('radio').last().check(),
  'a cage that is safe': async (child) => {
    await goesBack(child)
    await enters(textOf('safe-hill').title)(child)
    await guesses(textOf('safe-hill').guess.wish)(child)
    await stopsTime(child, 20)
    await child.presses('zoo.learn')
    await waits(child, allMoves)
  },
  'the last cage': async (child) => {
    await goesBack(child)
    await enters(textOf('leaves').title)(child)
  },
}

const spinner = senseTextOf('spinner')
const number = (child: Child, key: string, at: number) => child.word(key, { number: at })
const kind = (child: Child, at: number) =>
  child.page.getByRole('combobox', { name: number(child, 'zoo.senses.what', at), exact: true })
const coins = (child: Child, at: number) =>
  child.page.getByRole('spinbutton', { name: number(child, 'zoo.senses.coins', at), exact: true })

async function paysCoins(child: Child, at: number, text: string) {
  await coins(child, at).fill(text)
  await coins(child, at).press('Tab')
}

const watches = async (child: Child) => {
  await child.presses('zoo.senses.watch')
  await expect(child.button('zoo.senses.again')).toBeVisible()
}

const senses: Steps = {
  'the spinner': async (child) => {
    await follows(child, 'home.zoo')
    await enters(spinner.title)(child)
    await expect(child.page.getByText(spinner.soundsRight, { exact: true })).toBeVisible()
  },
  'a hint': (child) => child.presses('lab.hint'),
  'a guess': async (child) => {
    await child.presses('parts.close')
    await guesses(spinner.guess.cheats)(child)
  },
  'another guess': guesses(spinner.guess.honest),
  'Bo drives what it has learned': async (child) => {
    await stopsTime(child)
    await watches(child)
  },
  'Escape stops it after its first coins': async (child) => {
    await waits(child, 2000)
    await child.types('Escape')
    await waits(child, 30_000)
  },
  'once more, from each start': async (child) => {
    await child.presses('zoo.senses.again')
    await waits(child, 60_000)
  },
  'the first sentence pays for something else': (child) => kind(child, 1).selectOption({ index: 0 }),
  'it pays more': (child) => paysCoins(child, 1, '7'),
  'no number is not taken, too many coins are the most': async (child) => {
    await paysCoins(child, 1, '')
    await expect(coins(child, 1)).toHaveValue('7')
    await paysCoins(child, 1, '99')
  },
  'a sentence more': (child) => child.presses('zoo.senses.add'),
  'a sentence less': (child) => child.presses('zoo.senses.remove', { number: 1 }),
  'nothing is paid for': async (child) => {
    await paysCoins(child, 1, '0')
  },
  'the pay of the cage': (child) => child.presses('zoo.senses.restore'),
  'Bo learns with another pay until it is stopped': async (child) => {
    await paysCoins(child, 1, '3')
    await child.page.clock.resume()
    await stopsAtOnce(child)
    await child.presses('zoo.senses.try')
    await expect
      .poll(() => child.page.evaluate(() => (globalThis as { stoppedAt?: [number, number] }).stoppedAt))
      .toEqual([8, 0])
  },
  'the next cage': (child) => child.page.getByRole('link', { name: child.word('zoo.next') }).click(),
  'all animals': goesBack,
  'a bump ends it': enters(senseTextOf('crasher').title),
  'a riddle': async (child) => {
    const { title, guess } = senseTextOf('line-hopper')
    await goesBack(child)
    await enters(title)(child)
    await guesses(guess.cheats)(child)
    await watches(child)
  },
}

/** The button that stops is pressed once it appears, since Bo learns in a second. `stoppedAt`: minutes of the trial, and those of Bo. */
const stopsAtOnce = (child: Child) =>
  child.page.evaluate((name) => {
    new MutationObserver((_, observer) => {
      const stop = [...document.querySelectorAll('button')].find((one) => one.textContent.trim() === name)
      const bar = document.querySelector('progress')
      if (!stop || !bar) return
      observer.disconnect()
      Object.assign(globalThis, { stoppedAt: [bar.max, bar.value] })
      stop.click()
    }).observe(document.body, { childList: true, subtree: true })
  }, child.word('zoo.senses.stop'))

test('cages on maps, step by step', { tag: '@reward-zoo' }, ({ child }) =>
  goesThrough(child, 'reward-zoo', maps),
)

test('cages of sensors, step by step', { tag: '@reward-zoo' }, ({ child }) =>
  goesThrough(child, 'reward-zoo-senses', senses),
)
