import { leftEye, leftWheel, rightEye, rightWheel, type Child } from '../child.ts'
import { LooseHands } from '../child-loose.ts'
import { NetHands } from '../child-network.ts'
import { TimeHands } from '../child-time.ts'
import { freeProgram, looseNet } from '../projects.ts'
import { expect, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

const press =
  (key: string, facts = {}) =>
  (child: Child) =>
    child.presses(key, facts)

const hidden = { layer: 1, neuron: 1 }

test('knobs and neurons, step by step', { tag: '@network' }, async ({ child, page }) => {
  const net = new NetHands(child)
  const knob = child.knob(leftEye, leftWheel)
  const typed = page.locator('.stage input')
  const motor = child.nameOf(leftWheel)
  const does = page.getByRole('combobox', { name: child.word('net.activationOf', { name: motor }) })
  const link = page.locator('.stage svg path').first()
  await goesThrough(child, 'network', {
    'a card': () => opensCard(child, 'friendship'),
    'a weight is being typed': () => knob.press('0'),
    'it is no weight': () => typed.fill('7'),
    'it is left': () => typed.press('Escape'),
    'a weight is typed': async () => {
      await child.typesWeight(rightEye, leftWheel, 0.25)
      await child.typesWeight(leftEye, rightWheel, 0.3)
    },
    'arrows change a weight': () => knob.press('ArrowRight'),
    'a hand pulls a knob': () => child.dragsKnob(leftEye, leftWheel, 0.5),
    'a hand pulls beside a knob': async () => {
      const { x, y, width } = (await link.boundingBox())!
      await page.mouse.move(x + width / 2, y)
      await link.dispatchEvent('pointerdown', {
        button: 0,
        pointerId: 1,
        clientX: x + width / 4,
        clientY: y,
      })
      await page.mouse.up()
      await child.presses('network.showSum', { output: child.word('neuron.motor', { OUTPUTNODE: 'B' }) })
    },
    'Enter types': () => knob.press('Enter'),
    'it is typed': async () => {
      await typed.fill('0.4')
      await typed.press('Enter')
    },
    'an eye is touched': press('network.showWhere', { input: child.nameOf(rightEye) }),
    'the left motor is touched': () => child.output(leftWheel).click(),
    'the menu': press('network.settings'),
    'knobs from 0 to 10': () =>
      page.getByRole('switch', { name: child.word('lab.tens') }).click({ force: true }),
    'knobs from 0 to 1': () =>
      page.getByRole('switch', { name: child.word('lab.tens') }).click({ force: true }),
    'an explorer': () => child.words('net.levels.explorer').click(),
    'the menu is closed': press('network.settings'),
    'more bias': press('net.moreBias', { name: motor }),
    'less bias': async () => {
      await child.presses('net.lessBias', { name: motor })
      await child.presses('net.lessBias', { name: motor })
    },
    'bias by key': () => net.bias(motor).press('PageUp'),
    'a typed bias': async () => {
      await net.bias(motor).fill('12')
      await net.bias(motor).press('Enter')
    },
    'a layer more': press('net.addLayer'),
    'a neuron more': press('net.more', { layer: 1 }),
    'one neuron': async () => {
      for (let times = 0; times < 3; times += 1) await child.presses('net.fewer', { layer: 1 })
    },
    'it is touched': () => net.neuron(1, 1).click(),
    'an expert': () => net.chooses('expert'),
    'its neuron does something else': () =>
      page
        .getByRole('combobox', {
          name: child.word('net.activationOf', { name: child.word('net.hidden', hidden) }),
        })
        .selectOption('tanh'),
    'no layer': press('net.removeLayer', { layer: 1 }),
    'it does something else': () => does.selectOption('threshold'),
    'a sensor more': () => child.addsNeuron('addSensor'),
    'a motor more': () => child.addsNeuron('addMotor'),
    'a low screen': () => page.setViewportSize({ width: 1366, height: 560 }),
  })
})

test('brains and networks that do not run, step by step', { tag: '@network' }, async ({ child, page }) => {
  const net = new NetHands(child)
  const loose = new LooseHands(child)
  const dialog = child.dialog('net.brains')
  const name = dialog.getByRole('textbox', { name: child.word('net.name'), exact: true })
  await goesThrough(child, 'network-brains', {
    'a card': async () => {
      await opensCard(child, 'friendship')
      await child.typesWeight(rightEye, leftWheel, 0.75)
      await new TimeHands(child).adds('shared')
    },
    'the shelf': () => net.opensShelf(),
    'a name is typed': () => name.fill('mild'),
    'it is put there': press('net.put'),
    'another by key': async () => {
      await name.fill('other')
      await name.press('Enter')
    },
    'another name': async () => {
      await net.onShelf('mild').fill('wild')
      await net.onShelf('mild').press('Enter')
      await expect(net.onShelf('wild')).toBeVisible()
    },
    'it is taken': press('net.take'),
    'it is given to the other robot': () =>
      dialog
        .getByRole('button', { name: child.word('net.give', { robot: '' }).trim() })
        .first()
        .click(),
    'it is saved and removed': async () => {
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        child.presses('net.save', { name: 'wild' }),
      ])
      expect(download.suggestedFilename()).toMatch(/\.json$/)
      await child.presses('net.remove', { name: 'wild' })
    },
    'a file is refused': () => net.brings('Dear diary'),
    'the shelf is closed': () => dialog.getByRole('button', { name: child.word('parts.close') }).click(),
    'a network that is loose': async () => {
      await opensProject(child, 'Loose', looseNet('Loose'))
      await loose.seesLoose()
    },
    'it is left so': press('network.leaveLoose'),
    'it is asked about': () => page.locator('.later').getByRole('button').click(),
    'it is put in': () => loose.note.getByRole('button').first().click(),
    'a project without a network': async () => {
      await opensProject(
        child,
        'Counts',
        freeProgram('Counts', (make) => [make.wait(100)]),
      )
      await loose.unfolds()
    },
    'a network is put in': press('network.putOne'),
  })
})
