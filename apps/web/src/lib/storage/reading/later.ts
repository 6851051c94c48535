export { parseProject } from '@botgarten/programs'
