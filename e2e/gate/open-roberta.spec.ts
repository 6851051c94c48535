import { Comer, openRobertaFile } from '../child-open-roberta.ts'
import { leftEye, leftWheel } from '../child.ts'
import { expect, test, title } from './gate.ts'

test.use({ language: 'de' })

test(
  'a program of Open Roberta opens from home, drives, and is saved for Open Roberta with its weights',
  {
    tag: '@open-roberta',
  },
  async ({ child, page }) => {
    const comer = new Comer(child)
    await child.opensHome()
    await child.opensFileAtHome('Freundschaft.xml', openRobertaFile('thesis/friendship'))
    await comer.seesProgram('Freundschaft')
    await child.typesWeight(leftEye, leftWheel, 0.8)
    await child.pressesStart()
    await child.seesDriving()
    await child.pressesStop()
    const { name, text } = await comer.saves('asItIs')
    expect(name).toBe('Freundschaft.xml')
    await comer.opens('Wieder.xml', text)
    await comer.seesProgram('Wieder')
    await child.seesWeight(leftEye, leftWheel, 0.8)
    await expect(title(page)).toHaveText('Wieder')
  },
)
