// Rooms: network
import { LooseHands } from '../child-loose.ts'
import { test } from '../house.ts'
import { freeProgram, looseNet } from '../projects.ts'

test('a finger pulls a network to its place, and puts a loose one into the loop', async ({ child }) => {
  const hands = new LooseHands(child)
  await child.opensProjectAtHome(
    'Loop',
    freeProgram('Loop', (make) => [make.forever()]),
  )
  await hands.dropsNetwork()
  await hands.seesNumbers()
  await child.opensProject('Loose', looseNet('Loose'))
  await hands.seesLoose()
  await child.presses('problem.fix.intoLoop')
  await hands.seesNumbers()
})
