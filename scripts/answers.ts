// Works out the numbers of answers and writes them to content/materials/answers.json: `npm run answers`, after a card, a map or
// the learner has changed. The contract test says when it is due.
import { writeFileSync } from 'node:fs'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { answersOf } from '@botgarten/content/answers'
import { content } from '@botgarten/content/files'
import { format } from 'prettier'

addBlocks(learning)
const path = content.path('materials', 'answers.json')
writeFileSync(path, await format(JSON.stringify(answersOf(content)), { parser: 'json', printWidth: 110 }))
