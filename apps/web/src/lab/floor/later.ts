// Only a world on a picture of somebody's own needs it.
export { readPng } from '@botgarten/simulation'
