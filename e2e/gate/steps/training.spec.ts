import type { Child } from '../../child.ts'
import { NetHands } from '../../child-network.ts'
import { ProofHands } from '../../child-proof.ts'
import { sixRows, Teaching } from '../../child-training.ts'
import { expect, opensCard, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** The last two are against each other. */
const odd = `${sixRows}30,28,90,-40\n`
/** More rows than fit on the screen. */
const many = odd + '50,60,45,45\n'.repeat(40)
const foreign = 'a;b;c;d\n1,5;2;3;4\n6;7;8;9\n'
const broken = 'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,x,4\n5,6,7,8\n'

const press =
  (key: string, facts = {}) =>
  (child: Child) =>
    child.presses(key, facts)

/** Chooses an option by its label in each of these lists. */
const picks = (lists: { readonly [key: string]: string | { index: number } }) => async (child: Child) => {
  for (const [key, option] of Object.entries(lists))
    await child.page
      .getByRole('combobox', { name: child.word(key), exact: true })
      .selectOption(typeof option === 'string' ? { label: option } : option)
}

/** Turns switches of a menu over, whichever way they are. */
const turns =
  (...keys: readonly string[]) =>
  async (child: Child) => {
    for (const key of keys)
      await child.page.getByRole('switch', { name: child.word(key), exact: true }).click({ force: true })
  }

/** A button under the world. */
const hand = (child: Child, key: string) =>
  child.page.locator('.hand').getByRole('button', { name: child.word(key), exact: true })

const wheel = (child: Child, key: string) =>
  child.page.getByRole('slider', { name: child.word(key), exact: true })

/** Each entry of the menu saves a file; the menu is open before. */
async function savesEach(child: Child, ...keys: readonly string[]) {
  for (const [at, key] of keys.entries()) {
    if (at > 0) await child.presses('training.files')
    const [download] = await Promise.all([child.page.waitForEvent('download'), child.presses(key)])
    expect(download.suggestedFilename()).toMatch(key.endsWith('Json') ? /\.json$/ : /\.csv$/)
  }
}

/** Rows come for a moment; the last five seconds of them go again. */
async function drivesAndForgets(child: Child, drive: (seen: () => Promise<void>) => Promise<void>) {
  const teaching = new Teaching(child)
  const before = await teaching.count()
  await drive(async () => {
    await expect(child.words('training.recording')).toBeAttached()
    await expect.poll(() => teaching.count()).toBeGreaterThan(before)
  })
  await expect(child.words('training.recording')).not.toBeAttached()
  await child.presses('training.lastFive')
  await teaching.seesExamples(before)
  await hand(child, 'training.fromStart').click()
}

test('examples are shown, step by step', { tag: '@training' }, async ({ child, page }) => {
  const teaching = new Teaching(child)
  const asked = page.getByRole('status', { name: child.word('training.question') })
  await goesThrough(child, 'training-show', {
    'a card': () => opensCard(child, 'friendship'),
    'examples are wanted': () => teaching.shows(),
    'both wheels are set': async () => {
      await wheel(child, 'training.leftWheel').fill('45')
      await wheel(child, 'training.rightWheel').fill('60')
    },
    'a row is remembered': () => hand(child, 'training.remember').click(),
    'its detail is closed': press('training.close'),
    'a key pushes the pad': () => teaching.pad.press('ArrowUp'),
    'a hand pulls the pad aside': async () => {
      const { x, y } = await child.middleOf(teaching.pad)
      await page.mouse.move(x, y)
      await page.mouse.down()
      await expect(wheel(child, 'training.leftWheel')).toHaveValue('0')
      await page.mouse.move(x + 20, y - 20, { steps: 3 })
      await page.mouse.up()
      await page.mouse.move(x, y)
    },
    'another row is remembered': () => hand(child, 'training.remember').click(),
    'the last row is undone': () => hand(child, 'training.undoRow').click(),
    'a file is opened': () => teaching.opensFile('rows.csv', odd),
    'only its rows are kept': press('training.onlyThese'),
    'an asked row is looked at': () => asked.getByRole('button').first().click(),
    'it is looked at no more': () => teaching.table.locator('button[aria-pressed=true]').click(),
    'the field of examples': press('training.fieldView'),
    'a dot is chosen': () => page.locator('figure svg g').nth(1).dispatchEvent('click'),
    'the table again': press('training.tableView'),
    'nothing is chosen': press('training.close'),
    'the asked row is set aside': () =>
      asked.getByRole('button', { name: child.word('training.setAside') }).click(),
    'the menu of files': press('training.files'),
    'examples are saved': () =>
      savesEach(child, 'training.saveCsv', 'training.saveCsvAll', 'training.saveJson'),
    'the drawer': press('training.aside', { count: 1 }),
    'the row is taken back': () => teaching.table.locator('.bin button').first().click(),
    'the table after the drawer': press('training.toTable'),
    'an odd row is kept': press('training.keep'),
    'a table of other columns': async () => {
      await child.presses('training.files')
      const [chooser] = await Promise.all([
        page.waitForEvent('filechooser'),
        child.presses('training.openFile'),
      ])
      await chooser.setFiles({ name: 'other.csv', mimeType: 'text/csv', buffer: Buffer.from(foreign) })
      await expect(page.getByRole('dialog')).toBeVisible()
    },
    'another column is chosen': () =>
      page.getByRole('dialog').getByRole('combobox').first().selectOption({ index: 2 }),
    'the columns are left': press('training.cancel'),
    'the columns are taken': async () => {
      await teaching.opensFile('other.csv', foreign)
      await page.getByRole('dialog').getByRole('combobox').last().selectOption({ index: 0 })
      await child.presses('training.takeRows', { count: 2 })
    },
    'a broken table': () => teaching.opensFile('broken.csv', broken),
    'its bad row is left out': press('training.leaveOut', { count: 1 }),
    'a long table': () => teaching.opensFile('many.csv', many),
    'its rows alone': press('training.onlyThese'),
    'the table is scrolled': () => teaching.table.evaluate((box) => (box.scrollTop = 900)),
    'Bo is driven by key and by the hand on the pad': async () => {
      await teaching.chooses('drive')
      await drivesAndForgets(child, (seen) => teaching.drivesUntil(seen))
      await drivesAndForgets(child, async (seen) => {
        const { x, y } = await child.middleOf(teaching.pad)
        await page.mouse.move(x, y - 20)
        await page.mouse.down()
        await seen()
        await page.mouse.up()
        await page.mouse.move(x, y - 150)
      })
    },
    'a low screen has the hand above the table': () => page.setViewportSize({ width: 600, height: 800 }),
  })
})

test('examples are sorted and changed, step by step', { tag: '@training' }, async ({ child, page }) => {
  const teaching = new Teaching(child)
  const net = new NetHands(child)
  const wish = page.getByRole('textbox', { name: child.word('training.wish') }).first()
  const test = page.getByRole('checkbox', { name: child.word('training.isTest') })
  const heading = teaching.table.getByRole('columnheader').getByRole('button').first()
  const writes = (text: string) => async () => {
    await wish.fill(text)
    await wish.press('Tab')
  }
  await goesThrough(child, 'training-arrange', {
    'examples of an explorer': async () => {
      await opensCard(child, 'friendship')
      await net.chooses('explorer')
      await teaching.shows()
      await teaching.opensFile('rows.csv', sixRows)
    },
    'a row is chosen': () => teaching.table.locator('.number button').nth(1).click(),
    'another wish is written': writes('35'),
    'what is no number goes back': async () => {
      await writes('much')()
      await expect(wish).toHaveValue('35')
      await test.check()
    },
    'its drive is the test no more': () => test.uncheck(),
    'the row is closed': press('training.close'),
    'rows are sorted': () => heading.click(),
    'rows are sorted the other way': () => heading.click(),
    'the menu of order': press('training.arrange'),
    'one drive and one way are seen': picks({
      'training.drive': { index: 1 },
      'training.whichWay': 'right',
    }),
    'all are seen again': press('training.asShown'),
    'the menu is closed': () => child.types('Escape'),
    'a program is watched': () => teaching.chooses('copy'),
    'it drives and the drive is undone': async () => {
      await child.presses('training.begin.copy')
      await expect(hand(child, 'training.pause')).toBeVisible()
      await expect(child.words('training.recording')).toBeAttached()
      await hand(child, 'training.pause').click()
      await hand(child, 'training.begin.copy').click()
      await hand(child, 'training.pause').click()
      await hand(child, 'training.undoDrive').click()
      await child.pressesStop()
      await child.presses('lab.resetWorld')
    },
    'Bo is coached': () => teaching.chooses('coach'),
    'its eyes are not shown': () => hand(child, 'training.eyes').click(),
    'its eyes are shown': () => hand(child, 'training.eyes').click(),
    'the menu of an expert': async () => {
      await net.chooses('expert')
      await child.presses('training.arrange')
    },
    'a rate is chosen': picks({ 'training.rate': '30' }),
  })
})

test('examples are practised, step by step', { tag: '@training' }, async ({ child, page }) => {
  const teaching = new Teaching(child)
  const proof = new ProofHands(child)
  const bar = page.locator('.practise .bar .button.network')
  const round = (number: number) => expect(teaching.curve).toHaveAttribute('aria-valuenow', `${number}`)
  const next = (beat: string) => press(`training.next.${beat}`)
  const setUp = (speed: string, rounds: string, pace: string | { index: number }) =>
    picks({ 'training.speed': speed, 'training.roundsLabel': rounds, 'training.pace': pace })
  const missed = page.locator('.practise li button').first()
  await goesThrough(
    child,
    'training-practise',
    {
      'practice without examples': async () => {
        await opensCard(child, 'friendship')
        await teaching.letsPractise()
      },
      'examples are shown': async () => {
        await teaching.shows()
        await teaching.opensFile('rows.csv', sixRows)
        await teaching.seesExamples(6)
      },
      'practice with examples': () => page.locator('.show .next button').click(),
      'speed, rounds and pace are chosen': setUp('fast', '200', { index: 0 }),
      'it practises, pauses, begins from zero and goes to the end': async () => {
        await bar.click()
        await expect(child.button('training.oneExample')).toHaveAttribute('aria-disabled', 'true')
        await expect(bar).toHaveText(child.word('training.pause'))
        await bar.click()
        await expect(bar).not.toHaveText(child.word('training.pause'))
        await child.presses('training.fromZero')
        await round(0)
        await setUp('medium', '60', 'very fast')(child)
        await teaching.practises()
      },
      'the first round by key': () => teaching.curve.press('Home'),
      'a round by key': () => teaching.curve.press('ArrowRight'),
      'a hand goes along the curve': async () => {
        const { x, y, width, height } = (await teaching.curve.boundingBox())!
        await page.mouse.move(x + 2, y + height / 2)
        await page.mouse.down()
        await round(0)
        await page.mouse.move(x + width - 2, y + height / 2, { steps: 2 })
        await round(60)
        await page.mouse.up()
        await page.mouse.move(x, y - 40)
      },
      'how the error comes about': () => proof.asks(),
      'it is known': () => proof.closes(),
      'the field': press('training.fieldView'),
      alone: press('training.alone'),
      'Bo drives alone': async () => {
        await child.presses('training.aloneGo')
        await expect(page.getByText(/^Round 60: \d of 4$/)).toBeVisible()
      },
      'Bo drives alone without practice': async () => {
        await teaching.curve.press('Home')
        await child.presses('training.aloneGo')
        await expect(page.getByText(/^Round 0: \d of 4$/)).toBeVisible()
      },
      'a missed start is shown': () => missed.click(),
      'it is hidden': () => missed.click(),
      'the knobs': press('training.knobsView'),
      'one example': press('training.oneExample'),
      ...Object.fromEntries(
        ['inputs', 'sums', 'says', 'error', 'arrows'].map((beat) => [`its ${beat}`, next(beat)]),
      ),
      'why a knob moves': () => page.locator('.net button[aria-label*="?"]').first().click(),
      'it is said no more': press('training.closeWhy'),
      'the knobs move': next('knobs'),
      'the next example': next('example'),
      'it plays, pauses and is closed': async () => {
        await child.presses('training.play')
        await expect(child.button('training.pause')).toBeVisible()
        await expect(page.locator('.practise li[aria-current=step]')).toHaveText(/2/)
        await child.presses('training.pause')
        await expect(child.button('training.play')).toBeVisible()
        await child.presses('training.close')
        await child.presses('training.fromZero')
      },
      'Bo drives with a round': async () => {
        await teaching.practises()
        await child.pressesStart()
        await expect(child.words('training.drivesWith', { round: 60 })).toBeVisible()
        await child.pressesStop()
        await child.presses('lab.resetWorld')
        await expect(child.words('training.drivesWith', { round: 60 })).toBeHidden()
      },
      'the examples with their errors': () => teaching.shows(),
    },
    { hides: /(?<=nearer than )[\d.]+ c?m/g },
  )
})

test('practice is set up, step by step', { tag: '@training' }, async ({ child, page }) => {
  const teaching = new Teaching(child)
  const net = new NetHands(child)
  const own = async (key: string, text: string) => {
    const field = page.getByRole('textbox', { name: child.word(key) })
    await field.fill(text)
    await field.press('Tab')
  }
  const switches = ['mirror', 'push', 'keepBack', 'unit', 'patience'].map((name) => `training.${name}`)
  const over = turns(...switches)
  await goesThrough(child, 'training-settings', {
    'an explorer practises': async () => {
      await opensCard(child, 'friendship')
      await net.chooses('explorer')
      await teaching.shows()
      await teaching.opensFile('rows.csv', sixRows)
      await teaching.seesExamples(6)
      await teaching.letsPractise()
    },
    'more settings': press('training.more'),
    'all switches are turned': over,
    'all switches are turned back': over,
    'another seed': press('training.otherSeed'),
    'the menu is closed': () => child.types('Escape'),
    'an expert': () => net.chooses('expert'),
    'the settings of an expert': press('training.more'),
    'lists are chosen from': picks({
      'training.batch': '4',
      'training.optimizer': 'Adam',
      'training.momentum': '0.5',
      'training.decay': '0.001',
    }),
    'numbers are typed': async () => {
      await own('training.ownSpeed', '0.07')
      await own('training.ownRounds', '75')
    },
    'numbers beyond their bounds': async () => {
      await own('training.ownSpeed', '1000')
      await own('training.ownRounds', '1000000')
    },
    'it practises with them': async () => {
      await own('training.ownSpeed', '0.05')
      await own('training.ownRounds', '40')
      await child.types('Escape')
      await teaching.practises()
    },
    'an example of an expert': async () => {
      await child.presses('training.oneExample')
      for (const beat of ['inputs', 'sums', 'says', 'error', 'arrows'])
        await child.presses(`training.next.${beat}`)
      await page.locator('.net button[aria-label*="?"]').first().click()
    },
    'it is closed': press('training.close'),
    comparing: press('training.compare'),
    'seeds are compared': async () => {
      await child.presses('training.compareSeeds')
      await expect(page.getByRole('img', { name: child.word('training.compare') })).toBeVisible()
    },
    'sizes are compared': async () => {
      await child.presses('training.compareSizes')
      await expect(page.getByText(child.word('training.sizesText'))).toBeVisible()
    },
    'the examples of an expert': () => teaching.shows(),
    'sorted by their errors': () =>
      teaching.table
        .getByRole('columnheader')
        .getByRole('button', { name: child.word('training.off') })
        .click(),
  })
})

test('lamps, words and tones are shown, step by step', { tag: '@training' }, async ({ child, page }) => {
  const teaching = new Teaching(child)
  const words = page
    .getByRole('group', { name: child.word('training.others'), exact: true })
    .getByRole('button')
  await goesThrough(child, 'training-others', {
    'a card of words': async () => {
      await opensCard(child, 'say-it')
      await teaching.shows()
    },
    'a word is set': () => words.first().click(),
    'it is remembered': () => hand(child, 'training.remember').click(),
    'it is set off': () => words.first().click(),
    'another word is set': () => words.nth(1).click(),
    'nothing is said': () => words.last().click(),
    'the field of words': press('training.fieldView'),
    'a card of tones': async () => {
      await opensCard(child, 'loud-distance')
      await teaching.shows()
    },
    'a tone is set': () => page.locator('.hand input[type=range]').last().fill('70'),
    'a tone is remembered': () => hand(child, 'training.remember').click(),
    'it needs two sensors for a field': press('training.fieldView'),
  })
})
