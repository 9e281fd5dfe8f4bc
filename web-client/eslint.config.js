// What the compiler does not check in TypeScript: promises that no one waits for, casts that say nothing, and one way to write.
// Paths are from the root of the repository, where `npm run lint` starts it.
import tseslint from 'typescript-eslint';

const oneWay = [
    ['AssignmentExpression[operator="+="][right.value=1]', 'Write ++i.'],
    ['AssignmentExpression[operator="-="][right.value=1]', 'Write --i.'],
    ['ForStatement > UpdateExpression.update[prefix=false]', 'Write ++i.'],
    ['TemplateElement[value.raw=/type="number"/]', 'Write numberField(): browsers drop the commas of other languages.'],
    ['ExpressionStatement > UpdateExpression[prefix=false]', 'Write ++i.'],
].map(([selector, message]) => ({ selector, message }));

export default tseslint.config(
    { ignores: ['**/node_modules/', '**/dist/', 'web-client/toolchain/'] },
    {
        files: ['**/*.ts', 'web-client/tools/*.{js,mjs}'],
        extends: [tseslint.configs.recommendedTypeChecked],
        languageOptions: { parserOptions: { project: ['tsconfig.json'], tsconfigRootDir: import.meta.dirname } },
        linterOptions: { reportUnusedDisableDirectives: 'error' },
        rules: {
            'no-restricted-syntax': ['error', ...oneWay],
            eqeqeq: ['error', 'always', { null: 'ignore' }],
            curly: ['error', 'multi-line'],
            'no-var': 'error',
            'prefer-const': 'error',
            'object-shorthand': 'error',
            'no-warning-comments': ['error', { terms: ['/'], location: 'start' }],
            '@typescript-eslint/switch-exhaustiveness-check': 'error',
            '@typescript-eslint/consistent-type-imports': ['error', { fixStyle: 'inline-type-imports' }],
            '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_', varsIgnorePattern: '^_' }],
            '@typescript-eslint/no-unnecessary-type-assertion': 'error',
            // Lit binds handlers to their element; a fake may be asynchronous because what it stands for is.
            '@typescript-eslint/unbound-method': 'off',
            '@typescript-eslint/require-await': 'off',
        },
    },
);
