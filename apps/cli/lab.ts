// What commands need that run programs: every block, and how many stations each map has.
import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'

// No screen waits for a smaller first part here.
addBlocks(expert)
addBlocks(learning)
knowMaps(content)
